#pragma once

#include <Eigen/SparseCore>
#include <array>
#include <span>
#include <vector>

#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim {

/// The curvature of the implicit integrators, H_v^r = Σ_e κ_e^r / A_v^r with κ_e^r = (n₀ × n₁)·(x₁ − x₀) = |e| sin θ
/// over the edges e = (x₀, x₁) at v where exactly two triangles bound region r, n₀ and n₁ their normals out of r, n₀ of
/// the one that runs from x₀ to x₁; A_v^r is a third of the area of r's triangles at v. On a finely meshed ball of
/// radius R it tends to 4/R: there is no factor ½, so it is twice the curvature of the explicit scheme.
class SineCurvature {
 public:
  /// Who is next to whom; `geometry` (its numbering of entries (vertex, region)) is that of `mesh` as it is.
  SineCurvature(const lostopos::SurfaceMesh& mesh, const SurfaceGeometry& geometry);

  /// H by entry with the vertices at `positions` (L, one a slot): 1/L.
  void evaluate(std::span<const lostopos::Vec3> positions, std::vector<double>& curvature) const;

  /// ∂H/∂x there, exact, the change of normals, edges and areas included: a row an entry, column 3 v + i for coordinate
  /// i of vertex slot v; 1/L².
  Eigen::SparseMatrix<double, Eigen::RowMajor> derivative(std::span<const lostopos::Vec3> positions) const;

 private:
  // Two triangles of a region at an edge: the edge, and the corners opposite to it.
  struct Hinge {
    std::array<std::uint32_t, 4> vertices;  // x₀, x₁, the corner of the triangle that runs along, the other's
    std::array<std::uint32_t, 2> entries;   // of the region at x₀ and x₁
  };
  struct Side {  // of a triangle, towards one region
    std::array<std::uint32_t, 3> vertices, entries;
  };
  std::vector<double> areas(std::span<const lostopos::Vec3> positions) const;

  std::vector<Hinge> hinges_;
  std::vector<Side> sides_;
  std::size_t entries_ = 0;
  Eigen::Index columns_ = 0;
};

}  // namespace foamsim
