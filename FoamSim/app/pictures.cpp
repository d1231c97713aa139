#include "FoamSim/app/pictures.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <string>

#include "Base/console/terminal.h"
#include "Base/error.h"
#include "FoamSim/render/compose.h"
#include "FoamSim/render/png.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

// Beside an installed program, or in the source tree it was built from.
fs::path find_script(const std::string& script) {
  const fs::path program = fs::read_symlink("/proc/self/exe").parent_path();
  for (const fs::path& folder : {program / "../share/foamsim/plots", fs::path(FOAMSIM_PLOTS_DIR)})
    if (fs::exists(folder / script)) return folder / script;
  return {};
}

bool succeeds(std::vector<std::string> words) {
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  pid_t child = 0;
  if (posix_spawnp(&child, argv[0], nullptr, nullptr, argv.data(), environ) != 0) return false;
  int status = 0;
  return waitpid(child, &status, 0) == child && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

}  // namespace

render::Surface read_frame(const fs::path& file) {
  const lostopos::SurfaceData data = lostopos::read_surface(file);
  render::Surface surface;
  surface.positions = data.positions;
  surface.triangles = data.triangles;
  for (const lostopos::Labels& pq : data.labels)
    surface.labels.push_back({static_cast<std::int32_t>(pq.p.index()), static_cast<std::int32_t>(pq.q.index())});
  for (const lostopos::DataArray& array : data.triangle_arrays)
    if (array.name == "solid")
      for (double value : array.values) surface.hidden.push_back(value != 0 ? 1 : 0);
  return surface;
}

std::vector<render::Image> draw_together(const std::vector<render::Surface>& surfaces,
                                         const render::RenderOptions& options, const Eigen::Vector3d& direction) {
  render::FramingOptions framing;
  framing.direction = direction;
  framing.aspect = static_cast<double>(options.width) / options.height;
  const render::Camera camera = render::framing(surfaces, framing);
  std::vector<render::Image> images;
  images.reserve(surfaces.size());
  for (const render::Surface& surface : surfaces) images.push_back(render::render(surface, camera, options));
  return images;
}

void draw_frames(const std::vector<fs::path>& folders, std::size_t columns, const fs::path& file) {
  std::vector<render::Surface> surfaces;
  for (const fs::path& folder : folders) {
    std::vector<fs::path> frames;
    for (const auto& entry : fs::directory_iterator(folder)) frames.push_back(entry.path());
    std::ranges::sort(frames);
    for (std::size_t i = 0; i < columns; ++i)
      surfaces.push_back(read_frame(frames[i + 1 == columns ? frames.size() - 1 : i * frames.size() / (columns - 1)]));
  }
  render::RenderOptions options;
  options.width = 560;
  options.height = 420;
  const auto images = draw_together(surfaces, options, render::FramingOptions().direction);
  render::write_png(render::grid(images, {.columns = static_cast<int>(columns), .gap = 6}), file);
}

void draw_films(const Simulation& simulation, const std::array<double, 3>& direction, const fs::path& file) {
  const lostopos::SurfaceMesh& mesh = simulation.mesh();
  render::Surface films;
  std::vector<std::uint32_t> number(mesh.vertex_slots(), lostopos::Vertex::invalid_index);
  for (lostopos::Triangle t : mesh.triangles()) {
    if (simulation.solid()[t.index()] != 0) continue;
    std::array<std::uint32_t, 3> corners{};
    for (std::size_t k = 0; k < 3; ++k) {
      const lostopos::Vertex v = mesh.vertices(t)[k];
      if (number[v.index()] == lostopos::Vertex::invalid_index) {
        number[v.index()] = static_cast<std::uint32_t>(films.positions.size());
        films.positions.push_back(mesh.position(v));
      }
      corners.at(k) = number[v.index()];
    }
    films.triangles.push_back(corners);
    const lostopos::Labels pq = mesh.labels(t);
    films.labels.push_back({static_cast<std::int32_t>(pq.p.index()), static_cast<std::int32_t>(pq.q.index())});
  }
  render::RenderOptions options;
  options.width = 360;
  options.height = 270;
  const Eigen::Vector3d towards_eye(direction[0], direction[1], direction[2]);
  render::write_png(draw_together({films}, options, towards_eye).front(), file);
}

bool run_plot_script(const std::string& script, const fs::path& folder) {
  const fs::path file = find_script(script);
  if (file.empty()) return false;
  // Debian's matplotlib belongs to /usr/bin/python3, which need not be the first python3 on the path.
  for (const char* python : {"/usr/bin/python3", "python3"})
    if (succeeds({python, "-c", "import matplotlib"})) return succeeds({python, "-B", file.string(), folder.string()});
  return false;
}

void plot(const Program& program, const std::string& script, const fs::path& folder) {
  if (!run_plot_script(script, folder))
    base::print_warning(program.name, "no plot: it needs python3 with matplotlib and plots/" + script);
}

}  // namespace foamsim::app
