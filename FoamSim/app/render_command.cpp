#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <set>

#include "Base/error.h"
#include "Base/io/write_error.h"
#include "FoamSim/app/commands.h"
#include "FoamSim/app/common_arguments.h"
#include "FoamSim/app/pictures.h"
#include "FoamSim/app/session.h"
#include "FoamSim/render/png.h"

namespace foamsim::app {

namespace fs = std::filesystem;

namespace {

struct RenderArguments {
  std::vector<std::string> frames;
  std::string out, size = "800x600", background = "dark";
  std::vector<double> view{0.514, 0.242, 0.823};
  render::RenderOptions options;
  int threads = 0;
};

void require(bool right, const std::string& what_is_right) {
  if (!right) throw base::InputError(what_is_right);
}

void read_size(const std::string& size, render::RenderOptions& options) {
  constexpr int largest = 32768;
  int used = 0;
  const bool form = std::sscanf(size.c_str(), "%dx%d%n", &options.width, &options.height, &used) == 2 &&
                    static_cast<std::size_t>(used) == size.size();
  require(form, "--size " + size + " is not of the form WIDTHxHEIGHT, like 800x600");
  require(std::min(options.width, options.height) >= 1 && std::max(options.width, options.height) <= largest,
          "--size " + size + ": width and height have to be 1 to " + std::to_string(largest) + " pixels");
}

render::RenderOptions render_options(const RenderArguments& arguments) {
  render::RenderOptions options = arguments.options;
  read_size(arguments.size, options);
  const std::map<std::string, render::Background> backgrounds{{"dark", render::Background::dark},
                                                              {"white", render::Background::white},
                                                              {"transparent", render::Background::transparent}};
  options.background = backgrounds.at(arguments.background);
  require(options.samples >= 1 && options.samples <= 4096, "--samples has to be a whole number from 1 to 4096");
  require(options.tube_radius >= 0 && std::isfinite(options.tube_radius), "--tube-radius has to be a number >= 0");
  require(options.film_thickness > 0 && options.film_thickness <= 1500, "--thickness has to be in (0, 1500] nm");
  require(options.iridescence >= 0 && options.iridescence <= 1, "--iridescence has to be from 0 to 1");
  return options;
}

Eigen::Vector3d view_of(const RenderArguments& arguments) {
  Eigen::Vector3d view(arguments.view[0], arguments.view[1], arguments.view[2]);
  require(view.allFinite() && view.norm() > 0, "--view has to be a direction, like 0 0 1");
  return view;
}

std::vector<fs::path> picture_files(const RenderArguments& arguments) {
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

void draw(const RenderArguments& arguments) {
  const render::RenderOptions options = render_options(arguments);
  const Eigen::Vector3d view = view_of(arguments);
  const std::vector<fs::path> files = picture_files(arguments);
  std::vector<render::Surface> surfaces;
  for (const std::string& frame : arguments.frames) surfaces.push_back(read_frame(frame));
  const ThreadLimit limit = thread_limit(arguments.threads);
  base::make_folder(arguments.out);
  const std::vector<render::Image> images = draw_together(surfaces, options, view);
  for (std::size_t i = 0; i < images.size(); ++i) {
    render::write_png(images[i], files[i]);
    std::printf("%s\n", files[i].c_str());
  }
}

}  // namespace

void add_render_command(base::Command& root, const Program&) {
  using base::Argument;
  base::Command& command = root.add_command("render", "draw frames as pictures, all with the same camera");
  auto a = std::make_shared<RenderArguments>();
  command.add({.name = "frames",
               .target = &a->frames,
               .help = "mesh files",
               .required = true,
               .list = Argument::List::words,
               .offers = Argument::Offers::files});
  command.add({.name = "--out",
               .target = &a->out,
               .help = "folder for the pictures",
               .required = true,
               .offers = Argument::Offers::folders});
  command.add({.name = "--size", .target = &a->size, .help = "WIDTHxHEIGHT in pixels"});
  command.add({.name = "--background",
               .target = &a->background,
               .help = "dark, white or transparent",
               .names = {"dark", "white", "transparent"},
               .names_only = true});
  command.add({.name = "--view",
               .target = &a->view,
               .help = "direction from the films to the eye: X Y Z",
               .list = Argument::List::words,
               .count = 3});
  command.add({.name = "--samples", .target = &a->options.samples, .help = "rays a pixel"});
  command.add({.name = "--wireframe", .target = &a->options.wireframe, .help = "also draw the triangles' edges"});
  command.add({.name = "--tube-radius",
               .target = &a->options.tube_radius,
               .help = "Plateau borders' radius over half the picture's height"});
  command.add({.name = "--thickness", .target = &a->options.film_thickness, .help = "film thickness, nm"});
  command.add({.name = "--iridescence",
               .target = &a->options.iridescence,
               .help = "strength of the interference colours, 0 to 1"});
  add_threads(command, a->threads);
  command.set_action([a] {
    draw(*a);
    return exit_done;
  });
}

}  // namespace foamsim::app
