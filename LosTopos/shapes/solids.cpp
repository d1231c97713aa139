#include "LosTopos/shapes/solids.h"

#include <numbers>

#include "LosTopos/shapes/indexed_surface.h"

namespace lostopos {

namespace {

void push_out_to(IndexedSurface& surface, double radius) {
  for (Vec3& x : surface.points) x *= radius / x.norm();
}

IndexedSurface icosahedron() {
  constexpr double g = std::numbers::phi;
  return {{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
}

}  // namespace

SurfaceMesh icosphere(long n, double radius) {
  IndexedSurface surface = icosahedron();
  push_out_to(surface, radius);
  // Pushed out after every subdivision: the triangles stay more alike than if it were done once at the end.
  for (long i = 0; i < n; ++i) {
    surface = subdivided(std::move(surface), 1);
    push_out_to(surface, radius);
  }
  return as_bubble(surface);
}

SurfaceMesh tetrahedron(long n, double radius) {
  IndexedSurface surface{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}},
                         {{0, 1, 2}, {0, 3, 1}, {0, 2, 3}, {1, 3, 2}}};
  push_out_to(surface, radius);
  return as_bubble(subdivided(std::move(surface), n));
}

SurfaceMesh cube(long n, double radius) {
  IndexedSurface surface{
      {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1}, {-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}},
      {{0, 2, 1},
       {0, 3, 2},
       {4, 5, 6},
       {4, 6, 7},
       {0, 1, 5},
       {0, 5, 4},
       {1, 2, 6},
       {1, 6, 5},
       {2, 3, 7},
       {2, 7, 6},
       {3, 0, 4},
       {3, 4, 7}}};
  push_out_to(surface, radius);
  return as_bubble(subdivided(std::move(surface), n));
}

}  // namespace lostopos
