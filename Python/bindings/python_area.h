#pragma once

#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"
#include "Python/bindings/held_object.h"

namespace foamsim::python {

/// An area strategy that Python wrote: a function of a vertex's star. Called on all threads, one at a time.
class PythonArea final : public VertexArea {
 public:
  /// `areas(star)` returns one area (L²) a region of star.regions. To be called with the interpreter's lock.
  PythonArea(std::string name, pybind11::object areas) : name_(std::move(name)), areas_(hold(std::move(areas))) {}
  /// Throws base::InputError where that is not what it returns.
  void evaluate(const VertexStar& star, std::span<double> area) const override;

 private:
  std::string name_;
  HeldObject areas_;
};

}  // namespace foamsim::python
