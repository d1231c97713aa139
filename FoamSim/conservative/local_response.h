#pragma once

#include <span>
#include <vector>

#include "FoamSim/conservative/close_pairs.h"
#include "FoamSim/conservative/film_shape.h"
#include "FoamSim/conservative/near_field.h"

namespace foamsim {

/// What a force on the vertices does to their velocities in a unit of time, by the air nearby alone: force to pressure
/// to φ to Ψ to flux to velocity, with the sum of Ψ over triangles within 4 δ, cut off by a function that is positive
/// definite itself (Wendland 1995), so that the response is symmetric and positive as that of all the air. For short
/// waves it is nearly that; long ones it takes for slower than they are.
class LocalResponse {
 public:
  /// Of films that stay as they are; refers to its arguments. `delta`: δ, L.
  LocalResponse(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                double delta, const NearField& near);

  /// u (L/T²) of the force F (L⁴/T²) along which energy rises, both by vertex slot: −du/dt, so that F·u ≥ 0.
  void evaluate(std::span<const lostopos::Vec3> force, std::vector<lostopos::Vec3>& velocity);

 private:
  const FilmConnectivity& films_;
  const FilmShape& shape_;
  std::span<const lostopos::Vec3> positions_;
  NearField near_;
  ClosePairs pairs_;
  double unit_;                // of the kernel, 1/L
  std::vector<float> kernel_;  // singles, since it is the most of this in memory; they are as symmetric
  std::vector<double> pressure_, flux_;
  std::vector<lostopos::Vec3> strength_, potential_, still_;
};

}  // namespace foamsim
