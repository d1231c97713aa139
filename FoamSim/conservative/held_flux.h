#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "FoamSim/conservative/film_shape.h"
#include "FoamSim/conservative/near_field.h"
#include "FoamSim/sheet/velocity/pair_sums.h"

namespace foamsim {

/// Makes the air go with held vertices: the potentials there for which f_v^r = a_v^r·w_v, w the velocity of what holds
/// them. They are the multipliers of these conditions, and their system is the part M_hh of the kinetic energy's matrix
/// that belongs to held vertices: symmetric and, up to a constant at each vertex, positive.
class HeldFlux {
 public:
  /// As for FilmMotion.
  HeldFlux(double delta, const NearField& near) : delta_(delta), near_(near) {}

  /// For films of a given shape, until the next call; refers to its first three arguments. `driven`: by vertex slot,
  /// not zero where the air goes along.
  void update(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
              std::span<const std::uint8_t> driven);

  static constexpr long most_iterations = 200;
  /// Adds to `phi` (by entry, L²/T), at driven vertices alone, what changes `flux` (by entry, L³/T) there to that of
  /// vertices that move with `velocity` (L/T, by vertex slot). By conjugate gradients without a matrix, until what is
  /// missing is 1e-7 of the fluxes, by sums that are in single precision from many_triangles on; returns how many
  /// iterations that took.
  long solve(std::span<const double> flux, std::span<const lostopos::Vec3> velocity, std::span<double> phi);

 private:
  // −flux of potentials at the driven entries, at these.
  void apply(std::span<const double> phi, std::vector<double>& out);

  double delta_;
  NearField near_;
  DirectPairSums direct_{Precision::automatic};
  const FilmConnectivity* films_ = nullptr;
  const FilmShape* shape_ = nullptr;
  std::span<const lostopos::Vec3> positions_;
  std::vector<std::uint32_t> vertices_, entries_;  // that are driven
  std::vector<std::uint32_t> triangles_;           // around them
  VortexSources sources_;
  PairSums sums_;
  std::vector<double> all_phi_, flux_;                // by entry
  std::vector<lostopos::Vec3> strength_, potential_;  // by triangle
};

}  // namespace foamsim
