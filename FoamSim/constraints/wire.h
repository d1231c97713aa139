#pragma once

#include <optional>
#include <vector>

#include "FoamSim/constraints/constraint.h"
#include "FoamSim/constraints/wire_air.h"
#include "FoamSim/constraints/wire_spec.h"

namespace foamsim {

/// Wires that hold films and move them along prescribed paths; the air goes with them (docs/method.md "Wires"). Which
/// wire a vertex belongs to is its attribute "wire": 0 for none, 1 for what stands still without being named, and
/// behind that two numbers a wire, for the two groups that one with `pull` has.
class Wire final : public Constraint {
 public:
  /// `resolution`: h̄, L, what a step of `dt` (T; 0: not known yet) is compared with. Throws base::InputError for a wire
  /// that moves farther in a step than a film can follow.
  Wire(std::vector<WireSpec> wires, const WireAirOptions& air, double resolution, double dt);

  std::string_view name() const override { return "wire"; }
  /// Throws base::InputError for wires that match no vertex, or the same one, and where nothing is held at all.
  void attach(lostopos::SurfaceTracker& tracker) override;
  AirChange correct_circulation(const EffectStep& step, CirculationField& circulation, const SheetAir& air) override;
  void add_velocity(const Stage& stage, std::span<lostopos::Vec3> velocity) override;
  void tell_motion(const EffectStep& step, HeldMotion& motion) const override;
  void prescribe(const Stage& stage, std::span<lostopos::Vec3> positions) override;
  nlohmann::json state() const override;
  void restore(const nlohmann::json& state) override;

 private:
  using Path = std::int32_t;
  static constexpr Path none = 0, still = 1;
  static Path path(std::size_t wire, bool second_group) {
    return static_cast<Path>(2 + 2 * wire + (second_group ? 1 : 0));
  }
  void require_known_paths(const lostopos::SurfaceMesh& mesh) const;
  void hold(const lostopos::SurfaceMesh& mesh, std::size_t wire, const std::vector<lostopos::Vertex>& vertices);
  // Of a vertex on that path between two times, L.
  lostopos::Vec3 displacement(Path path, double start, double end) const;
  std::vector<std::uint8_t> wired() const;
  // Whether any of them has an axis, which has to be remembered.
  bool pulls() const;

  std::vector<WireSpec> wires_;
  std::vector<lostopos::Vec3> axes_;  // of those that pull, by wire
  WireAir air_;
  std::optional<lostopos::VertexAttribute<Path>> paths_;
};

}  // namespace foamsim
