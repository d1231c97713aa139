#pragma once

#include <optional>

#include "FoamSim/constraints/constraint.h"
#include "FoamSim/constraints/rod_chain.h"
#include "FoamSim/constraints/selection.h"
#include "FoamSim/constraints/wire_air.h"

namespace foamsim {

struct RodOptions {
  RodMaterial material = {};
  bool looped = true;                   ///< closed; else open between the first vertex and the last
  std::optional<Selection> fixed = {};  ///< vertices that do not move
  double pull = 0;                      ///< force over length with which a film pulls, in the rod's units
  /// As the reference program has it: two steps of dt in each, its scheme, and the pull of all triangles, solid or not.
  bool reference = false;
};

/// An elastic rod that carries the films' border: what the mesh marks as held is a chain in order round the border, is
/// stepped before the films with their pull, and the air goes with it (docs/method.md "Wires"). Its attributes: "rod",
/// the place in the chain from 1 on, and "rod_velocity" (L/T).
class Rod final : public Constraint {
 public:
  Rod(const RodOptions& options, const WireAirOptions& air) : options_(options), air_(air) {}

  std::string_view name() const override { return "rod"; }
  /// Throws base::InputError where held vertices do not form one chain, or one without length.
  void attach(lostopos::SurfaceTracker& tracker) override;
  AirChange correct_circulation(const EffectStep& step, CirculationField& circulation, const SheetAir& air) override;
  void add_velocity(const Stage& stage, std::span<lostopos::Vec3> velocity) override;
  void tell_motion(const EffectStep& step, HeldMotion& motion) const override;
  void prescribe(const Stage& stage, std::span<lostopos::Vec3> positions) override;
  nlohmann::json state() const override;
  void restore(const nlohmann::json& state) override;

 private:
  // The vertices from the first to the last.
  std::vector<lostopos::Vertex> chain(const lostopos::SurfaceMesh& mesh) const;
  // Of a rod that is on its way: sees to it that there is a vertex at each place, as many as fixed_ has entries.
  void find_chain(const lostopos::SurfaceMesh& mesh);
  void make_chain(std::vector<double> lengths, std::vector<char> fixed);
  std::vector<RodFilm> films(const EffectStep& step, const std::vector<lostopos::Vertex>& vertices,
                             std::span<const lostopos::Vec3> x) const;
  std::vector<std::uint8_t> wired() const;
  // Takes the rod from the step's start to its end.
  void advance(const EffectStep& step);

  RodOptions options_;
  WireAir air_;
  std::vector<char> fixed_;
  std::optional<RodChain> rod_;
  std::optional<lostopos::VertexAttribute<std::int32_t>> places_;
  std::optional<lostopos::VertexAttribute<lostopos::Vec3>> velocities_;
  // Of the step that is being made, by vertex slot.
  std::vector<lostopos::Vec3> targets_;
  std::vector<lostopos::Vec3> before_;
};

}  // namespace foamsim
