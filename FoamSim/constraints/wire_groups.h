#pragma once

#include <vector>

#include "FoamSim/constraints/wire_spec.h"

namespace foamsim {

/// The two groups of a wire that pulls, and the direction from the first to the second.
struct WireGroups {
  std::vector<char> second;  ///< by place in the list of vertices
  lostopos::Vec3 axis;       ///< of length 1
};

/// Parts the vertices: by the wire's axis where it has one, at the middle of their extent along it; else into the two
/// pieces that edges of the mesh join; where these are not two, at the middle of the coordinate in which they extend
/// farthest. Without a given axis it is the direction from the mean of the first to that of the second, of which the
/// first has the lower such coordinate. Throws base::InputError for vertices that cannot be parted.
WireGroups part_groups(const lostopos::SurfaceMesh& mesh, const WireSpec& wire,
                       const std::vector<lostopos::Vertex>& vertices);

}  // namespace foamsim
