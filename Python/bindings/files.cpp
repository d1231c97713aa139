#include <pybind11/stl.h>

#include "Base/error.h"
#include "FoamSim/render/render.h"
#include "LosTopos/io/mesh_file.h"
#include "Python/bindings/arrays.h"
#include "Python/bindings/bindings.h"

namespace foamsim::python {

namespace py = pybind11;

namespace {

py::tuple read_mesh(const std::string& path) {
  const lostopos::SurfaceData data = lostopos::read_surface(path);
  return py::make_tuple(vectors(data.positions), corners(data.triangles), label_pairs(data.labels));
}

void write_mesh(const std::string& path, const py::object& positions, const py::object& triangles,
                const py::object& labels) {
  lostopos::write_surface(path, to_surface(positions, triangles, labels));
}

render::Background background_of(const std::string& name) {
  if (name == "dark") return render::Background::dark;
  if (name == "white") return render::Background::white;
  if (name == "transparent") return render::Background::transparent;
  throw base::InputError("background: '" + name + "' is none of dark, white, transparent");
}

py::array pixels_of(const render::Image& image, py::ssize_t channels) {
  py::array_t<std::uint8_t> array(
      {static_cast<py::ssize_t>(image.height()), static_cast<py::ssize_t>(image.width()), channels});
  std::uint8_t* to = array.mutable_data();
  for (const render::Pixel& pixel : image.pixels()) to = std::copy_n(pixel.data(), channels, to);
  return array;
}

struct Look {
  int width, height, samples;
  std::string background;
  std::array<double, 3> direction;
};

py::array draw(const py::object& positions, const py::object& triangles, const py::object& labels,
               const std::vector<bool>& hidden, const Look& look) {
  const lostopos::SurfaceData data = to_surface(positions, triangles, labels);
  render::Surface surface{data.positions, data.triangles, {}, {hidden.begin(), hidden.end()}};
  for (const lostopos::Labels& pq : data.labels)
    surface.labels.push_back({static_cast<std::int32_t>(pq.p.index()), static_cast<std::int32_t>(pq.q.index())});
  if (look.width < 1 || look.height < 1)
    throw base::InputError("width and height have to be whole numbers from 1 to 32768");
  render::RenderOptions options;
  options.width = look.width;
  options.height = look.height;
  options.samples = look.samples;
  options.background = background_of(look.background);
  render::FramingOptions framing;
  framing.direction = {look.direction[0], look.direction[1], look.direction[2]};
  framing.aspect = static_cast<double>(look.width) / look.height;
  render::Image image;
  {
    const py::gil_scoped_release unlocked;
    image = render::render(surface, render::framing(surface, framing), options);
  }
  return pixels_of(image, options.background == render::Background::transparent ? 4 : 3);
}

}  // namespace

void bind_files(py::module_& module) {
  using namespace py::literals;
  module.def("read_mesh", &read_mesh, "path"_a);
  module.def("write_mesh", &write_mesh, "path"_a, "positions"_a, "triangles"_a, "labels"_a);
  module.def(
      "render",
      [](const py::object& positions, const py::object& triangles, const py::object& labels,
         const std::vector<bool>& hidden, int width, int height, int samples, const std::string& background,
         const std::array<double, 3>& direction) {
        return draw(positions, triangles, labels, hidden, {width, height, samples, background, direction});
      },
      "positions"_a, "triangles"_a, "labels"_a, "hidden"_a, "width"_a, "height"_a, "samples"_a, "background"_a,
      "direction"_a);
}

}  // namespace foamsim::python
