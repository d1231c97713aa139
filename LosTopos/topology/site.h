#pragma once

#include <span>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/operation_events.h"
#include "LosTopos/mesh/surface_mesh.h"
#include "LosTopos/remeshing/vertex_rank.h"

namespace lostopos {

/// A place of the surface where something is to be joined, with what it lies on.
struct Site {
  Place place;
  Vec3 point = Vec3::Zero();  ///< L
  Vertex vertex;              ///< valid: the place is this vertex
  Edge edge;                  ///< valid: within this edge
  Triangle triangle;          ///< valid: within this triangle

  std::span<const Vertex> vertices() const { return {place.vertices.data(), place.count}; }
  bool uses(Vertex v) const;
};

/// The vertex v.
Site site_at(const SurfaceMesh& mesh, Vertex v);
/// a + t (b − a) on e = (a, b).
Site site_on(const SurfaceMesh& mesh, Edge e, double t);
/// The mean of t's corners by `weights`; on an edge or a vertex of t where weights are 0.
Site site_in(const SurfaceMesh& mesh, Triangle t, const Vec3& weights);

/// The site, moved to a vertex of its own that is nearer than `reach` (L), or else from within a triangle to a side of
/// it that is. So snapping makes fewer small triangles.
Site settled(const SurfaceMesh& mesh, const Site& site, double reach);

/// The triangles that have the site in them.
SurfaceMesh::TriangleList triangles_at(const SurfaceMesh& mesh, const Site& site);

/// How much the site is bound by the films that meet there.
VertexRank rank(const SurfaceMesh& mesh, const Site& site);

/// Whether the site's vertices are all held: nothing may move there.
bool is_held(const VertexAttribute<Hold>& held, const Site& site);

/// How much of the unit vector `direction` is normal to the surface at the site: the largest over the films (by pair of
/// regions) that meet there of |n · direction|, n the film's area-weighted unit normal. In [0, 1].
double transversality(const SurfaceMesh& mesh, const Site& site, const Vec3& direction);

}  // namespace lostopos
