#pragma once

#include "FoamSim/constraints/constraint.h"
#include "FoamSim/constraints/wire_films.h"

namespace foamsim {

struct WireAirOptions {
  bool interior = true;        ///< circulation where wires hold films in their middle
  bool open_boundary = false;  ///< vortices along wires at which films end
  double interior_weight = 0;  ///< λ of the regularised least squares, L, > 0
  double open_weight = 0.1;    ///< μ, T/L², > 0
};

/// Makes the air go with the films that wires hold, for dynamics that know of Γ and velocities: the two solves of
/// docs/method.md "Wires".
class WireAir {
 public:
  explicit WireAir(const WireAirOptions& options) : options_(options) {}

  /// Γ and vortices for which the predicted motion along the normals, over step.dt, is that to `targets` (L, by vertex
  /// slot), as far as the regularised least squares bring it there. `wired`: by vertex slot, not zero for those that
  /// the wires hold.
  AirChange solve(const EffectStep& step, std::span<const std::uint8_t> wired, std::span<const lostopos::Vec3> targets,
                  CirculationField& circulation, const SheetAir& air);
  /// By vertex slot, not zero where the air has to go along according to the options, for dynamics that see to it by
  /// themselves: inside films, and at open edges.
  std::vector<std::uint8_t> takes_air(const EffectStep& step, std::span<const std::uint8_t> wired) const;
  /// Adds the velocity (L/T) that the vortices of the last solve give to vertices at stage.positions.
  void add_velocity(const Stage& stage, std::span<lostopos::Vec3> velocity) const;

  /// The edges with vortices, and their strengths (L³/T).
  std::span<const OpenEdge> open_edges() const { return edges_; }
  const Eigen::VectorXd& strengths() const { return strengths_; }

 private:
  WireAirOptions options_;
  std::vector<OpenEdge> edges_;
  Eigen::VectorXd strengths_;
  double delta_ = 0;
};

}  // namespace foamsim
