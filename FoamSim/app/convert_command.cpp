#include <spdlog/spdlog.h>

#include <cstdio>
#include <memory>

#include "FoamSim/app/commands.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim::app {
namespace {

// What the source holds and the target's format has no place for.
void warn_of_losses(const std::string& out, const lostopos::SurfaceData& data) {
  const lostopos::MeshFormat* format = lostopos::find_mesh_format(out);
  if (format == nullptr) return;
  if (!format->keeps_circulation && (!data.circulation.empty() || !data.held.empty()))
    spdlog::warn("{} files have no place for circulation and held vertices; they are left out", format->extension);
  if (!format->keeps_arrays && (!data.vertex_arrays.empty() || !data.triangle_arrays.empty()))
    spdlog::warn("{} files have no place for data arrays; they are left out", format->extension);
}

}  // namespace

void add_convert_command(CLI::App& app, Program& program) {
  CLI::App* command = app.add_subcommand("convert", "convert a mesh file; the endings say the formats");
  auto in = std::make_shared<std::string>(), out = std::make_shared<std::string>();
  command->add_option("in", *in, "file to read (" + lostopos::mesh_extensions() + ")")->required();
  command->add_option("out", *out, "file to write")->required();
  command->callback([in, out, &program] {
    const lostopos::SurfaceData data = lostopos::read_surface(*in);
    lostopos::write_surface(*out, data);
    warn_of_losses(*out, data);
    std::printf("%s: %zu vertices, %zu triangles\n", out->c_str(), data.positions.size(), data.triangles.size());
    program.exit_code = exit_done;
  });
}

}  // namespace foamsim::app
