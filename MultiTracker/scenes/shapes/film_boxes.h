#pragma once

#include "LosTopos/mesh/surface_mesh.h"

namespace multitracker {

struct FourCellsOptions {
  lostopos::Vec3 size = {1.2, 0.6, 0.6};  ///< of the box, L
  double gap = 0.12;                      ///< between the two junction lines, L; 0: all four films meet in one line
  long layers = 4;                        ///< rows of films along z, before subdivision
  long subdivisions = 2;
};
/// A box from the origin whose inside is divided by four films that leave its four creases along z: region 1 above
/// (towards +y), 2 below, 3 on the left, 4 on the right. With a gap regions 3 and 4 have a film of that width between
/// them in the middle, and 1 and 2 do not meet.
lostopos::SurfaceMesh four_cells(const FourCellsOptions& options);

/// The unit box in three prisms, regions 1, 2, 3, which meet in a line along z through its middle.
lostopos::SurfaceMesh three_cells(long layers, long subdivisions);

/// A tetrahedron with its corners at distance 1 from the origin, divided into four regions, one at each face, around a
/// similar one in the middle of the given size (0 to 1): region 5.
lostopos::SurfaceMesh nested_tetrahedra(double size, long subdivisions);

enum class PrismMiddle { edge, face };
struct FilmPrismOptions {
  double height = 0.3;                     ///< between the two triangles, whose sides are 1 long, L
  PrismMiddle middle = PrismMiddle::edge;  ///< what the films have in the middle
  double size = 0.1;                       ///< length of that edge, or of a side of that face, L
  long subdivisions = 3;
};
/// A triangular prism about the z axis with films from its nine edges inward: regions 1 above, 2 below, and 3, 4, 5 at
/// the sides. In the middle an edge along z, in which 3, 4 and 5 meet, joins two Plateau vertices; or a triangular face
/// parts 1 from 2, and 3, 4 and 5 do not all meet.
lostopos::SurfaceMesh film_prism(const FilmPrismOptions& options);

/// An open film of radius r about the x axis between two rings at ±half_length, region 1 inside: `segments` around.
/// Its ends are the rings' vertices at ±half_length to the bit.
lostopos::SurfaceMesh open_tube(double radius, double half_length, long segments);

}  // namespace multitracker
