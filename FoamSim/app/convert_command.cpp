#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "Base/console/terminal.h"
#include "Base/error.h"
#include "Base/io/write_error.h"
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
  const auto all_kept = [](const std::vector<lostopos::DataArray>& arrays, std::span<const std::string_view> kept) {
    return std::ranges::all_of(arrays,
                               [kept](const auto& array) { return std::ranges::find(kept, array.name) != kept.end(); });
  };
  if (!format->keeps_arrays && !(all_kept(data.vertex_arrays, format->kept_vertex_arrays) &&
                                 all_kept(data.triangle_arrays, format->kept_triangle_arrays)))
    lose("data arrays");
  if (!lost.empty())
    base::print_warning(program.name,
                        std::string(format->extension) + " files have no place for " + lost + ", left out here");
}

namespace fs = std::filesystem;

// A path with one * in the name of its file, or none.
struct FilePattern {
  std::string text;
  fs::path folder;
  std::string before, after;
  bool has_star;

  explicit FilePattern(const std::string& path) : text(path), folder(fs::path(path).parent_path()) {
    const std::string name = fs::path(path).filename().string();
    const std::size_t star = name.find('*');
    has_star = star != std::string::npos;
    before = name.substr(0, star);
    after = has_star ? name.substr(star + 1) : "";
    if (std::ranges::count(path, '*') > (has_star ? 1 : 0))
      throw base::InputError("'" + path + "': one * is possible, in the name of the file");
  }

  std::string with(const std::string& part) const { return (folder / (before + part + after)).string(); }
};

// What the * stands for in the files that there are, ascending.
std::vector<std::string> parts_of_files(const FilePattern& pattern) {
  std::vector<std::string> parts;
  std::error_code failed;
  for (const auto& entry : fs::directory_iterator(pattern.folder.empty() ? "." : pattern.folder, failed)) {
    const std::string name = entry.path().filename().string();
    const std::size_t fixed = pattern.before.size() + pattern.after.size();
    if (name.size() >= fixed && name.starts_with(pattern.before) && name.ends_with(pattern.after))
      parts.push_back(name.substr(pattern.before.size(), name.size() - fixed));
  }
  if (parts.empty())
    throw base::InputError("no file has a name like '" + pattern.text + "'" +
                           (failed ? ": " + failed.message() : std::string()));
  std::ranges::sort(parts);
  return parts;
}

void convert_file(const Program& program, const std::string& in, const std::string& out) {
  const lostopos::SurfaceData data = lostopos::read_surface(in);
  lostopos::write_surface(out, data);
  warn_of_losses(program, out, data);
  std::printf("%s: %zu vertices, %zu triangles\n", out.c_str(), data.positions.size(), data.triangles.size());
}

void convert_files(const Program& program, const FilePattern& in, const FilePattern& out) {
  if (!out.has_star)
    throw base::InputError("'" + in.text + "' may be many files, '" + out.text + "' is one; name it with a *, too");
  const std::vector<std::string> parts = parts_of_files(in);
  lostopos::require_mesh_format(out.text);
  if (!out.folder.empty()) base::make_folder(out.folder);
  for (const std::string& part : parts) convert_file(program, in.with(part), out.with(part));
}

}  // namespace

void add_convert_command(base::Command& root, const Program& program) {
  base::Command& command = root.add_command("convert", "convert mesh files; the endings say the formats");
  auto in = std::make_shared<std::string>(), out = std::make_shared<std::string>();
  command.add({.name = "in",
               .target = in.get(),
               .help = "file to read (" + lostopos::mesh_extensions() + "); with a *, in quotes, all of such names",
               .required = true,
               .offers = base::Argument::Offers::files});
  command.add({.name = "out",
               .target = out.get(),
               .help = "file to write; its * stands for what that of 'in' does",
               .required = true,
               .offers = base::Argument::Offers::files});
  command.set_action([in, out, &program] {
    const FilePattern from(*in), to(*out);
    if (from.has_star)
      convert_files(program, from, to);
    else
      convert_file(program, *in, *out);
    return exit_done;
  });
}

}  // namespace foamsim::app
