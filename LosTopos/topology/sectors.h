#pragma once

#include <boost/container/small_vector.hpp>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// A part of the neighbourhood of a vertex that its films cut out. A region may have several.
struct Sector {  // NOLINT(bugprone-exception-escape): lists of triangles throw only for want of memory
  Region region;
  SurfaceMesh::TriangleList triangles;  ///< of the vertex, that bound it
};

/// How the films at a vertex divide its neighbourhood. In general position (a film, a Plateau border, a Plateau vertex)
/// every two sectors have a film between them.
struct Neighbourhood {
  /// Parts that have only the vertex in common, each a list of triangles. One, unless the vertex is pinched.
  std::vector<SurfaceMesh::TriangleList> parts;
  /// Of a vertex that is not pinched.
  std::vector<Sector> sectors;
  bool consistent = true;  ///< false: neighbouring films disagree on the region between them (sectors are left out)
};

/// Whether every two sectors at v have a film between them, decided from the number of films, edges and regions alone
/// (Euler's formula for the drawing that the films make on a small sphere around v). True, too, where a film ends at v:
/// then v belongs to a wire.
bool is_complete(const SurfaceMesh& mesh, Vertex v);

/// The parts and sectors at v. The order of films around each edge is found from the positions.
Neighbourhood neighbourhood(const SurfaceMesh& mesh, Vertex v);

/// A triangle at an edge that is looked at along it.
struct FilmAtEdge {
  double angle;          ///< of a turn about the edge, counter-clockwise as seen from where it points
  Triangle triangle;     ///< or the index of a planned one
  Region before, after;  ///< the regions met before and after the film on this turn
};
using FilmsAtEdge = boost::container::small_vector<FilmAtEdge, 4>;

/// The films at the edge from v to w in the order of a turn about it.
FilmsAtEdge films_around(const SurfaceMesh& mesh, Vertex v, Edge e);

}  // namespace lostopos
