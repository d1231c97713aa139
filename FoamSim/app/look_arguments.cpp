#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>

#include "Base/error.h"
#include "FoamSim/app/look.h"

namespace foamsim::app {
namespace {

using Eigen::Vector3d;

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

bool all_finite(const std::vector<double>& list) {
  return std::ranges::all_of(list, [](double x) { return std::isfinite(x); });
}

std::optional<Vector3d> point(const std::string& name, const std::vector<double>& list) {
  if (list.empty()) return std::nullopt;
  require(all_finite(list), name + " has to be three finite numbers");
  return Vector3d(list[0], list[1], list[2]);
}

render::RenderOptions render_options(const LookArguments& arguments) {
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
  require(options.color_opacity >= 0 && options.color_opacity < 1, "--opacity has to be from 0 to below 1");
  return options;
}

}  // namespace

Look LookArguments::look() const {
  Look result;
  result.options = render_options(*this);
  result.framing.direction = {view[0], view[1], view[2]};
  require(result.framing.direction.allFinite() && result.framing.direction.norm() > 0,
          "--view has to be a direction, like 0 0 1");
  require(zoom >= 0.05 && zoom <= 1000, "--zoom has to be from 0.05 to 1000");
  result.framing.zoom = zoom;
  result.eye = point("--eye", eye);
  result.target = point("--target", target);
  if (!cut.empty()) {
    result.cut = render::CutPlane{{cut[0], cut[1], cut[2]}, cut[3]};
    require(all_finite(cut) && result.cut->normal.norm() > 0,
            "--cut has to be a direction and an offset: what lies beyond the plane is taken away, as by 0 0 1 0.5");
  }
  require(explode >= 0 && explode <= 100, "--explode has to be from 0 to 100");
  result.explode = explode;
  result.color = color;
  if (!range.empty()) {
    require(all_finite(range) && range[0] < range[1], "--range has to be two finite numbers, the lower first");
    require(result.has_field(), "--range is that of a field, which --color has to name");
    result.range = render::FieldRange{range[0], range[1]};
  }
  result.scale_bar = scale_bar;
  return result;
}

void LookArguments::add_to(base::Command& command) {
  using base::Argument;
  const auto numbers = [&command](const char* name, std::vector<double>& list, int count, const char* help) {
    command.add({.name = name, .target = &list, .help = help, .list = Argument::List::words, .count = count});
  };
  command.add({.name = "--size", .target = &size, .help = "WIDTHxHEIGHT in pixels"});
  command.add({.name = "--background",
               .target = &background,
               .help = "dark, white or transparent",
               .names = {"dark", "white", "transparent"},
               .names_only = true});
  numbers("--view", view, 3, "direction from the films to the eye: X Y Z");
  numbers("--eye", eye, 3, "where the eye is, in place of a distance from which all is seen: X Y Z, L");
  numbers("--target", target, 3, "what is in the middle of the picture, in place of the films' middle: X Y Z, L");
  command.add({.name = "--zoom", .target = &zoom, .help = "how many times larger"});
  command.add({.name = "--color",
               .target = &color,
               .help = "interference, regions, pressure, or an array of the files",
               .names = {"interference", "regions", "pressure"}});
  numbers("--range", range, 2, "values at the ends of the colours of a field: LOW HIGH");
  command.add({.name = "--opacity", .target = &options.color_opacity, .help = "of films with colours, 0 to below 1"});
  numbers("--cut", cut, 4, "take away what lies beyond a plane: its normal X Y Z and offset D, X x + Y y + Z z > D");
  command.add({.name = "--explode",
               .target = &explode,
               .help = "bubbles apart, by so many times the distance from the foam's middle"});
  command.add({.name = "--scale-bar", .target = &scale_bar, .help = "a line with its length"});
  command.add({.name = "--samples",
               .target = &options.samples,
               .help = "rays a pixel where there is something to smooth; elsewhere at most four"});
  command.add({.name = "--wireframe", .target = &options.wireframe, .help = "also draw the triangles' edges"});
  command.add({.name = "--tube-radius",
               .target = &options.tube_radius,
               .help = "Plateau borders' radius over half the picture's height"});
  command.add({.name = "--thickness", .target = &options.film_thickness, .help = "film thickness, nm"});
  command.add({.name = "--iridescence",
               .target = &options.iridescence,
               .help = "strength of the interference colours, 0 to 1"});
}

}  // namespace foamsim::app
