#include "FoamSim/app/pictures.h"

#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <string>

#include "Base/console/terminal.h"
#include "Base/error.h"
#include "FoamSim/render/compose.h"
#include "FoamSim/render/legend.h"
#include "FoamSim/render/png.h"
#include "LosTopos/io/film_faces.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/run/run_frames.h"

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

// One camera that shows all of them, seen from `direction`.
render::Camera camera_for(const std::vector<render::Surface>& surfaces, const render::RenderOptions& options,
                          const Eigen::Vector3d& direction) {
  render::FramingOptions framing;
  framing.direction = direction;
  framing.aspect = static_cast<double>(options.width) / options.height;
  return render::framing(surfaces, framing);
}

}  // namespace

render::Surface to_draw(const lostopos::SurfaceData& data) {
  render::Surface surface;
  surface.positions = data.positions;
  surface.triangles = data.triangles;
  for (const lostopos::Labels& pq : data.labels)
    surface.labels.push_back({static_cast<std::int32_t>(pq.p.index()), static_cast<std::int32_t>(pq.q.index())});
  const std::vector<std::uint8_t> solid = lostopos::solid_triangles(data);
  surface.hidden.assign(solid.begin(), solid.end());
  return surface;
}

void draw_frames(const std::vector<fs::path>& runs, std::size_t columns, const fs::path& file) {
  render::RenderOptions options;
  options.width = 560;
  options.height = 420;
  std::vector<render::Surface> surfaces;
  std::vector<std::string> labels;
  for (const fs::path& run : runs) {
    const std::vector<lostopos::run::RunFrame> frames = lostopos::run::run_frames(run);
    for (std::size_t i = 0; i < columns; ++i) {
      const auto& frame = frames[i + 1 == columns ? frames.size() - 1 : i * frames.size() / (columns - 1)];
      surfaces.push_back(to_draw(lostopos::read_surface(frame.file)));
      std::array<char, 32> time{};
      std::snprintf(time.data(), time.size(), ", time %.4g T", frame.time);
      labels.push_back(run.filename().string() + time.data());
    }
  }
  const render::Camera camera = camera_for(surfaces, options, render::FramingOptions().direction);
  std::vector<render::Image> images;
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    images.push_back(render::render(surfaces[i], camera, options));
    render::draw_label(images.back(), labels[i], options.background);
    render::draw_scale_bar(images.back(), camera, "L", options.background);
  }
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
  render::write_png(render::render(films, camera_for({films}, options, towards_eye), options), file);
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
