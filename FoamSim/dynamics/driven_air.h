#pragma once

#include "FoamSim/conservative/held_flux.h"
#include "FoamSim/constraints/constraint.h"

namespace foamsim {

/// What wires and rods do in the conservative dynamics: vertices go as they are driven, and where the air has to go
/// along the flux is that of their motion, and the potentials are what that takes.
class DrivenAir {
 public:
  DrivenAir(double delta, const NearField& near) : flux_(delta, near) {}

  /// The motion during the step that begins; empty: nothing is driven, and nothing of this acts.
  void begin(HeldMotion motion);
  bool acts() const { return !motion_.driven.empty(); }
  /// Whether the air has to go along anywhere.
  bool takes_air() const { return takes_air_; }
  /// Whether a velocity is another one than in the step before.
  bool jumps() const;

  /// Gives driven vertices their velocity (L/T, by vertex slot).
  void prescribe(std::span<lostopos::Vec3> velocity) const;
  /// Σ F·w over driven vertices, L⁵/T³.
  double power(std::span<const lostopos::Vec3> force) const;
  /// Σ ½ (F + F')·(x' − x) over them, L⁵/T²: `force_sum` is F + F'.
  double work(std::span<const lostopos::Vec3> force_sum, std::span<const lostopos::Vec3> from,
              std::span<const lostopos::Vec3> to) const;

  /// Changes φ where the air has to go along so that `flux`, which is that of φ, becomes that of their motion;
  /// `iterations` is raised to what that took. Returns the work of the forces for it, L⁵/T²: −Σ Δφ a·(w + w'), w' the
  /// velocity now and w that before where the change is one of velocity (`jump`), else the same.
  double hold(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
              std::span<const double> flux, bool jump, std::span<double> phi, long& iterations);

 private:
  HeldMotion motion_;
  bool takes_air_ = false;
  HeldFlux flux_;
};

}  // namespace foamsim
