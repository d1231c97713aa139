#include "FoamSim/scenes/shapes/wands.h"

#include <string>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/held.h"

namespace foamsim {

using lostopos::air;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

namespace {

void require_segments(long n) {
  if (n < 3) throw base::InputError("a ring needs at least 3 vertices; n = " + std::to_string(n));
}

}  // namespace

Ring add_straw(SurfaceMesh& mesh, const StrawShape& shape) {
  require_segments(shape.segments);
  Ring held = add_ring(mesh, shape.segments, shape.mouth, 1, shape.axis);
  const Labels along{shape.inside, air};
  add_fan(mesh, add_point(mesh, shape.mouth, shape.axis), held, along);
  const Vertex tip = add_point(mesh, shape.mouth - 1, shape.axis);
  add_fan(mesh, tip, held, along.flipped());
  held.push_back(tip);
  return held;
}

SurfaceMesh wand(long n) {
  SurfaceMesh mesh;
  mark_held(mesh, add_straw(mesh, {.segments = n}));
  return mesh;
}

SurfaceMesh two_rings(long n) {
  require_segments(n);
  SurfaceMesh mesh;
  const double radius = 0.5, place = 0.15;
  const Labels outwards{Region(1), air};
  const Ring left = add_ring(mesh, n, -place, radius);
  const Ring middle = add_ring(mesh, n, 0, radius);
  const Ring right = add_ring(mesh, n, place, radius);
  add_belt(mesh, left, middle, outwards);
  add_belt(mesh, middle, right, outwards);
  const Vertex left_tip = add_point(mesh, -place - 1), right_tip = add_point(mesh, place + 1);
  add_fan(mesh, left_tip, left, outwards.flipped());
  add_fan(mesh, right_tip, right, outwards);
  Ring held{left_tip, right_tip};
  held.insert(held.end(), left.begin(), left.end());
  held.insert(held.end(), right.begin(), right.end());
  mark_held(mesh, held);
  return mesh;
}

SurfaceMesh barrel(long n, long rings) {
  require_segments(n);
  if (rings < 2) throw base::InputError("a barrel needs at least 2 rings; m = " + std::to_string(rings));
  SurfaceMesh mesh;
  const auto height = [rings](long i) { return static_cast<double>(i) / static_cast<double>(rings - 1) - 0.5; };
  Ring below = add_ring(mesh, n, height(0), 1, Axis::y);
  for (long i = 1; i < rings; ++i) {
    Ring ring = add_ring(mesh, n, height(i), 1, Axis::y);
    add_belt(mesh, below, ring, {Region(1), air});
    below = std::move(ring);
  }
  return mesh;
}

}  // namespace foamsim
