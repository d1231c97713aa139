#pragma once

#include "Base/parallel/for_each.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Calls body(h) for every living element of a kind, in parallel (see base::parallel_for_each).
template <class Body>
void for_each_vertex(const SurfaceMesh& mesh, const Body& body, std::size_t grain = 256) {
  base::parallel_for_each(mesh.vertex_slots(), grain, [&](std::size_t i) {
    if (const Vertex v(i); mesh.alive(v)) body(v);
  });
}
template <class Body>
void for_each_edge(const SurfaceMesh& mesh, const Body& body, std::size_t grain = 256) {
  base::parallel_for_each(mesh.edge_slots(), grain, [&](std::size_t i) {
    if (const Edge e(i); mesh.alive(e)) body(e);
  });
}
template <class Body>
void for_each_triangle(const SurfaceMesh& mesh, const Body& body, std::size_t grain = 256) {
  base::parallel_for_each(mesh.triangle_slots(), grain, [&](std::size_t i) {
    if (const Triangle t(i); mesh.alive(t)) body(t);
  });
}

}  // namespace lostopos
