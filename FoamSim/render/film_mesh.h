#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "FoamSim/render/surface.h"

namespace foamsim::render {

/// A segment between two points.
using Segment = std::array<Eigen::Vector3f, 2>;

/// A surface made ready to be drawn: single precision, in scene units (half the picture's height at the target is 1,
/// the target is the origin), with shading normals and the lines along which films meet or end.
struct FilmMesh {
  std::vector<Eigen::Vector3f> positions;
  /// Visible triangles of nonzero area.
  std::vector<std::array<std::uint32_t, 3>> triangles;
  /// Unit face normals, by right-hand rule; one a triangle.
  std::vector<Eigen::Vector3f> face_normals;
  /// Unit shading normals at the three corners, on the side of the face normal: the angle-weighted mean over the
  /// triangles reached around the vertex through edges that have exactly two triangles, of one region pair, bent by
  /// less than 60 degrees. So a vertex on a Plateau border has one normal for each film, and a sharp crease stays
  /// sharp.
  std::vector<std::array<Eigen::Vector3f, 3>> corner_normals;
  /// Linear sRGB at the three corners, as the surface has it; empty where it has none.
  std::vector<std::array<Eigen::Vector3f, 3>> corner_colors;
  /// A number that is the same for triangles of the same region pair.
  std::vector<std::uint32_t> films;
  /// Edges with three or more visible triangles, or, where none is hidden, two of different region pairs.
  std::vector<Segment> borders;
  /// Edges with one visible triangle.
  std::vector<Segment> rims;
  /// Mean edge length, scene units; 0 if there is no triangle.
  float mean_edge = 0;
};

/// @param origin, scale  scene units are (x − origin) / scale.
/// @throws base::InputError  if the surface has no triangles, its arrays disagree, an index is out of range or a
/// position
///         is not finite.
FilmMesh prepare(const Surface& surface, const Eigen::Vector3d& origin, double scale);

}  // namespace foamsim::render
