#pragma once

#include <optional>
#include <string>

#include "FoamSim/constraints/selection.h"
#include "FoamSim/effects/effect.h"

namespace foamsim {

struct BlowOptions {
  double rate = 20;                               ///< of Γ, L²/T², ≥ 0
  lostopos::Region region = lostopos::Region(1);  ///< that is blown up
  double until = 0;                               ///< T; 0: for ever
  std::string where = "held";                     ///< the straw's vertices: a Selection; held ones of them
};

/// Blowing through a straw (docs/method.md "Effects"): at its vertices, which are held, the pressure in a region is
/// higher than outside by twice a rate, so that Γ^{0b} −= rate dt there, and likewise Γ towards other regions. So air
/// flows in at these vertices: with dynamics that keep fluxes they are a mouth, where no wire says how much.
class Blow final : public Effect {
 public:
  /// Throws base::InputError for a selection that means nothing.
  explicit Blow(BlowOptions options) : options_(std::move(options)), where_(options_.where) {}
  std::string_view name() const override { return "blow"; }
  void attach(lostopos::SurfaceMesh& mesh) override;
  /// Throws base::InputError for a region that the surface does not have, or a selection without vertices that are
  /// held.
  void begin(const EffectStep& step) override;
  std::span<const std::uint8_t> mouth(double time) const override;
  bool drives(double time) const override { return options_.rate > 0 && is_on(time); }
  void drive_circulation(const EffectStep& step, CirculationField& circulation) override;

 private:
  // A step blows where it begins before the end.
  bool is_on(double time) const { return options_.until == 0 || time < options_.until; }

  BlowOptions options_;
  Selection where_;
  std::optional<lostopos::VertexAttribute<std::uint8_t>> straw_;
};

}  // namespace foamsim
