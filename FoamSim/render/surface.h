#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

namespace foamsim::render {

/// The films to draw, as plain arrays.
struct Surface {
  /// Vertex positions, any unit of length.
  std::vector<Eigen::Vector3d> positions;
  /// Vertex indices, three a triangle.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Region pair (p, q) of each triangle: its right-hand normal points out of p into q. As long as `triangles`.
  std::vector<std::array<std::int32_t, 2>> labels;
  /// Optional: one flag a triangle, nonzero leaves it out of the picture (solid patches). Empty: nothing is hidden.
  std::vector<char> hidden;
  /// Optional: linear sRGB at the three corners of each triangle, with which its film is coloured in place of
  /// interference (see `RenderOptions::color_opacity`). Empty: clear films.
  std::vector<std::array<Eigen::Vector3f, 3>> colors = {};
};

}  // namespace foamsim::render
