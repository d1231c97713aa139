#include <algorithm>
#include <cstdio>
#include <memory>

#include "Base/console/terminal.h"
#include "FoamSim/app/commands.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim::app {
namespace {

// What the source holds and the target's format has no place for.
void warn_of_losses(const Program& program, const std::string& out, const lostopos::SurfaceData& data) {
  const lostopos::MeshFormat* format = lostopos::find_mesh_format(out);
  if (format == nullptr) return;
  std::string lost;
  const auto lose = [&lost](const char* what) { lost.append(lost.empty() ? "" : ", ").append(what); };
  if (!format->keeps_pair_arrays && !data.pair_arrays.empty()) lose("circulation");
  if (!format->keeps_held && !data.held.empty()) lose("held vertices");
  const auto is_kept = [format](const lostopos::DataArray& array) { return array.name == format->kept_array; };
  if (!format->keeps_arrays && (!data.vertex_arrays.empty() || !std::ranges::all_of(data.triangle_arrays, is_kept)))
    lose("data arrays");
  if (!lost.empty())
    base::print_warning(program.name,
                        std::string(format->extension) + " files have no place for " + lost + ", left out here");
}

}  // namespace

void add_convert_command(base::Command& root, const Program& program) {
  base::Command& command = root.add_command("convert", "convert a mesh file; the endings say the formats");
  auto in = std::make_shared<std::string>(), out = std::make_shared<std::string>();
  command.add({.name = "in",
               .target = in.get(),
               .help = "file to read (" + lostopos::mesh_extensions() + ")",
               .required = true,
               .offers = base::Argument::Offers::files});
  command.add({.name = "out",
               .target = out.get(),
               .help = "file to write",
               .required = true,
               .offers = base::Argument::Offers::files});
  command.set_action([in, out, &program] {
    const lostopos::SurfaceData data = lostopos::read_surface(*in);
    lostopos::write_surface(*out, data);
    warn_of_losses(program, *out, data);
    std::printf("%s: %zu vertices, %zu triangles\n", out->c_str(), data.positions.size(), data.triangles.size());
    return exit_done;
  });
}

}  // namespace foamsim::app
