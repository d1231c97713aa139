#include <cstdio>
#include <map>
#include <memory>
#include <set>

#include "Base/error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/session.h"
#include "FoamSim/render/png.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

struct Arguments {
  std::vector<std::string> frames;
  std::string out, size = "800x600", background = "dark";
  std::vector<double> view{0.514, 0.242, 0.823};
  render::RenderOptions options;
  int threads = 0;
};

void apply(const Arguments& arguments, render::RenderOptions& options) {
  int used = 0;
  if (std::sscanf(arguments.size.c_str(), "%dx%d%n", &options.width, &options.height, &used) != 2 ||
      static_cast<std::size_t>(used) != arguments.size.size())
    throw base::InputError("--size " + arguments.size + " is not of the form WIDTHxHEIGHT, like 800x600");
  const std::map<std::string, render::Background> backgrounds{{"dark", render::Background::dark},
                                                              {"white", render::Background::white},
                                                              {"transparent", render::Background::transparent}};
  const auto it = backgrounds.find(arguments.background);
  if (it == backgrounds.end())
    throw base::InputError("--background " + arguments.background + " is not one of dark, white, transparent");
  options.background = it->second;
}

std::vector<fs::path> picture_files(const Arguments& arguments) {
  std::vector<fs::path> files;
  std::set<fs::path> taken;
  for (const std::string& frame : arguments.frames) {
    files.push_back(fs::path(arguments.out) / (fs::path(frame).stem().string() + ".png"));
    if (!taken.insert(files.back()).second)
      throw base::InputError("two frames would both become " + files.back().string() +
                             "; draw them into different folders");
  }
  return files;
}

void draw(const Arguments& arguments) {
  render::RenderOptions options = arguments.options;
  apply(arguments, options);
  const std::vector<fs::path> files = picture_files(arguments);
  std::vector<render::Surface> surfaces;
  for (const std::string& frame : arguments.frames) surfaces.push_back(read_frame(frame));
  const ThreadLimit limit(arguments.threads);
  std::error_code error;
  fs::create_directories(arguments.out, error);
  if (error) throw base::FileError("cannot make the folder " + arguments.out + ": " + error.message());
  const Eigen::Vector3d view(arguments.view[0], arguments.view[1], arguments.view[2]);
  const std::vector<render::Image> images = draw_together(surfaces, options, view);
  for (std::size_t i = 0; i < images.size(); ++i) {
    render::write_png(images[i], files[i]);
    std::printf("%s\n", files[i].c_str());
  }
}

}  // namespace

void add_render_command(CLI::App& app, Program& program) {
  CLI::App* command = app.add_subcommand("render", "draw frames as pictures, all with the same camera");
  auto a = std::make_shared<Arguments>();
  command->add_option("frames", a->frames, "mesh files")->required();
  command->add_option("--out", a->out, "folder for the pictures")->required();
  command->add_option("--size", a->size, "WIDTHxHEIGHT in pixels")->capture_default_str();
  command->add_option("--background", a->background, "dark, white or transparent")->capture_default_str();
  command->add_option("--view", a->view, "direction from the films to the eye: X Y Z")->expected(3);
  command->add_option("--samples", a->options.samples, "rays a pixel")->capture_default_str();
  command->add_flag("--wireframe", a->options.wireframe, "also draw the triangles' edges");
  command->add_option("--tube-radius", a->options.tube_radius, "Plateau borders' radius over half the picture's height")
      ->capture_default_str();
  command->add_option("--thickness", a->options.film_thickness, "film thickness, nm")->capture_default_str();
  command->add_option("--iridescence", a->options.iridescence, "strength of the interference colours, 0 to 1")
      ->capture_default_str();
  command->add_option("--threads", a->threads, "number of threads (default: all cores)");
  command->callback([a, &program] {
    draw(*a);
    program.exit_code = exit_done;
  });
}

}  // namespace foamsim::app
