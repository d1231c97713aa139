#pragma once

#include <Eigen/SparseCore>
#include <vector>

#include "FoamSim/dynamics/integrator_kick.h"
#include "FoamSim/sheet/pressure/sine_curvature.h"

namespace foamsim {

/// The equation that the integrators `implicit` and `pbd` solve for ΔΓ, by (vertex, pair):
///
///   C(ΔΓ) = ΔΓ − dt σ (H^p − H^q)(x') = 0,  x' = x + dt (∂u/∂Γ)(Γ + ΔΓ),
///
/// with H of SineCurvature, and u the sheet's velocities at the start's positions x, which are linear in Γ. Its
/// derivative is J = I − dt² σ (∂H/∂x)(∂u/∂Γ), ∂H/∂x at x'. No dense matrix is made: J v is a velocity sum for Γ = v
/// and a product with the sparse ∂H/∂x. At held vertices Γ stays and x' = x; triangles of a solid have no vorticity.
class ImplicitTension {
 public:
  explicit ImplicitTension(const CirculationKick& kick);

  /// How many ΔΓ there are.
  Eigen::Index size() const { return static_cast<Eigen::Index>(start_.size()); }
  /// Goes to x' of ΔΓ and returns C there, L²/T.
  Eigen::VectorXd residual(const Eigen::VectorXd& change);
  /// ∂H/∂x and with it J become those of the positions of the last `residual`.
  void linearise();
  /// J v and Jᵀ w, after `linearise`. J v is a sum over triangles for every vertex; so is Jᵀ w.
  Eigen::VectorXd apply(const Eigen::VectorXd& v) const;
  Eigen::VectorXd apply_transposed(const Eigen::VectorXd& w) const;
  /// |J_i|² of every row: a sum over triangles for each of the dozen vertices that a row's ∂H/∂x knows of.
  Eigen::VectorXd squared_rows() const;

  /// Γ + ΔΓ into the circulation.
  void add(const Eigen::VectorXd& change) const;

 private:
  using Row = Eigen::SparseMatrix<double, Eigen::RowMajor>;

  // A corner's share of Γ in the arrays: which, and with which sign for the triangle's own labels.
  struct Corner {
    std::uint32_t entry;
    double sign;
  };
  void number(const CirculationKick& kick);
  void gather(const CirculationKick& kick);
  // dt ∂u/∂Γ times values by entry: displacements by vertex slot.
  void displacements(const Eigen::VectorXd& values, std::vector<lostopos::Vec3>& moved) const;
  // Adds (∂u/∂Γ)ᵀ y for vectors y at some vertices.
  void add_adjoint(std::span<const std::uint32_t> vertices, std::span<const lostopos::Vec3> y,
                   Eigen::VectorXd& sum) const;

  const CirculationKick& kick_;
  SineCurvature curvature_;
  std::vector<std::uint32_t> first_;                 // by vertex slot + 1, into the entries
  std::vector<double> start_;                        // Γ, by entry
  std::vector<std::array<std::uint32_t, 2>> sides_;  // entries of H^p and H^q, by entry
  std::vector<std::uint8_t> free_;                   // by entry: not at a held vertex
  std::vector<std::array<Corner, 3>> corners_;       // by triangle of sheet_
  mutable std::vector<SheetTriangle> sheet_;
  mutable std::vector<lostopos::Vec3> moved_;
  std::vector<lostopos::Vec3> positions_;  // x'
  std::vector<double> h_;
  Row pairs_;  // ∂(H^p − H^q)/∂x, a row an entry
};

}  // namespace foamsim
