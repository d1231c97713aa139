#pragma once

#include <vector>

#include "LosTopos/collision/near_triangles.h"

namespace lostopos {

/// The mesh's triangles by place, for one pass. It takes in the mesh when first asked, so that a pass that changes
/// nothing does not pay for it, and follows every edit from then on.
class SurfaceIndex {
 public:
  /// `given`: what is to be used and kept up to date, from pass to pass; or null.
  SurfaceIndex(const SurfaceMesh& mesh, NearTriangles* given) : mesh_(mesh), given_(given) {}

  NearTriangles* given() const { return given_; }

  /// The triangles whose boxes overlap `box`, sorted, in `found` (cleared first).
  void nearby(const Box& box, std::vector<Triangle>& found);
  /// Triangles in `found` (cleared first), in no particular order, among them all of which an element may be nearer
  /// than `distance` to one of t's, elements that have a vertex in common aside.
  void near(Triangle t, double distance, std::vector<Triangle>& found);
  /// Triangles in `found` (cleared first), perhaps repeated, among them all of which an element can come nearer than
  /// `distance` to one of those of v's triangles while v moves to x, elements that have a vertex in common aside. False
  /// when that is not known without a search.
  bool near_moving(Vertex v, const Vec3& x, double distance, std::vector<Triangle>& found);
  /// To be called after a triangle was added or its corners moved.
  void changed(Triangle t);
  /// To be called when a triangle is removed.
  void removed(Triangle t);

 private:
  NearTriangles& used();

  const SurfaceMesh& mesh_;
  NearTriangles* given_;
  NearTriangles own_;
  NearTriangles* used_ = nullptr;
};

}  // namespace lostopos
