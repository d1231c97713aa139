#include "Python/bindings/python_area.h"

#include <pybind11/stl.h>

#include <cmath>

#include "Base/error.h"

namespace foamsim::python {

namespace py = pybind11;

void PythonArea::evaluate(const VertexStar& star, std::span<double> area) const {
  area_of_own_triangles(star, area);
  const py::gil_scoped_acquire lock;
  py::object seen = py::module_::import("types").attr("SimpleNamespace")();
  std::vector<std::uint32_t> regions;
  for (lostopos::Region r : star.regions) regions.push_back(r.index());
  const lostopos::Vec3& x = star.mesh.position(star.vertex);
  seen.attr("vertex") = star.vertex.index();
  seen.attr("position") = py::make_tuple(x.x(), x.y(), x.z());
  seen.attr("regions") = regions;
  seen.attr("junction") = star.junction;
  seen.attr("own_areas") = std::vector<double>(area.begin(), area.end());
  std::vector<double> given;
  try {
    given = (*areas_)(seen).cast<std::vector<double>>();
  } catch (const py::cast_error&) {
    throw base::InputError("area strategy '" + name_ + "': a list of numbers is needed, one a region of the star");
  }
  if (given.size() != area.size())
    throw base::InputError("area strategy '" + name_ + "': " + std::to_string(given.size()) + " areas for " +
                           std::to_string(area.size()) + " regions");
  for (double value : given)
    if (!(std::isfinite(value) && value > 0))
      throw base::InputError("area strategy '" + name_ + "': an area of " + std::to_string(value) +
                             ", which has to be finite and > 0");
  std::ranges::copy(given, area.begin());
}

}  // namespace foamsim::python
