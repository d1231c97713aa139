#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCholesky>
#include <array>
#include <functional>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// N_t of a triangle with its corners at x (L, by slot), L².
lostopos::Vec3 area_vector_at(const lostopos::SurfaceMesh& mesh, lostopos::Triangle t,
                              std::span<const lostopos::Vec3> x);

/// The closed bubbles of a surface and their volumes (L³): not those that a solid closes, through which air goes.
std::map<lostopos::Region, double> closed_bubbles(const lostopos::SurfaceMesh& mesh);

/// The volumes V_r of bubbles as constraints on vertices: their gradients a_v^r = ∂V_r/∂x_v, and the system
///
///   Σ_s (Σ_v a_v^r·a_v^s / A_v) λ_s = b_r
///
/// of the displacements Σ_r λ_r a_v^r / A_v, of all that change the volumes by b the least for vertices that weigh as
/// much as the area A_v around them (a third of their triangles').
class BubbleVolumes {
 public:
  /// One row a bubble, in the order of the regions. Refers to the mesh, whose elements stay as they are.
  BubbleVolumes(const lostopos::SurfaceMesh& mesh, const std::map<lostopos::Region, double>& wanted);

  Eigen::Index rows() const { return wanted_.size(); }
  /// What the volumes lack to those that are wanted, for vertices at x (L, by slot).
  Eigen::VectorXd missing(std::span<const lostopos::Vec3> x) const;

  /// Takes gradients and areas at x; vertices that are not free have none. False where the system has no solution.
  bool update(std::span<const lostopos::Vec3> x, const std::function<bool(lostopos::Vertex)>& is_free);
  /// @name After an update
  ///@{
  /// λ; empty where it is not finite.
  Eigen::VectorXd solve(const Eigen::VectorXd& b) const;
  /// Σ_v a_v^r·w_v / A_v, by row, for any vectors w, by vertex slot.
  Eigen::VectorXd product(std::span<const lostopos::Vec3> w) const;
  /// Adds Σ_r λ_r a_v^r to `out`, by vertex slot, over A_v where it says so.
  void add(const Eigen::VectorXd& factors, bool over_area, std::span<lostopos::Vec3> out) const;
  ///@}

 private:
  struct Star {
    std::vector<std::pair<int, lostopos::Vec3>> gradients;
    double area = 0;
  };
  Star star(lostopos::Vertex v, std::span<const lostopos::Vec3> x) const;

  const lostopos::SurfaceMesh& mesh_;
  std::vector<std::array<int, 2>> rows_;  // of both labels, by triangle slot; -1: none of these bubbles
  Eigen::VectorXd wanted_;
  std::vector<Star> stars_;
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> solver_;
};

}  // namespace foamsim
