#pragma once

#include <map>
#include <vector>

#include "FoamSim/effects/effect.h"

namespace foamsim {

/// Keeps the volumes of closed bubbles (docs/method.md "A conservative scheme", 9): after the motion of a step every
/// vertex goes by Σ_r λ_r a_v^r / A_v, the least displacement that brings volumes back to what they have to be, by two
/// Newton steps on a sparse system of one row a bubble. They change by what other effects do: by the velocities that
/// they add and what they blow in, and when a bubble is gone, into another by a contact, which then takes over what it
/// had to be; a bubble that bursts into the air leaves nothing. Bubbles with an open boundary are left alone, and so
/// are those that a solid closes, through which air goes, and held vertices.
class Volumes final : public Effect {
 public:
  std::string_view name() const override { return "volumes"; }
  void attach(lostopos::SurfaceMesh& mesh) override;
  /// What a region that bursts has had is air then.
  void region_bursts(lostopos::Region region) override { wanted_.erase(region); }
  void volume_let_in(lostopos::Region region, double volume) override;
  void velocity_added(const Stage& stage, std::span<const lostopos::Vec3> added) override;
  void move_vertices(const Stage& stage, std::span<lostopos::Vec3> positions) override;
  /// The same for what topology changes and remeshing have done, where it is more than a millionth of a volume.
  bool settle(const EffectStep& step, std::span<lostopos::Vec3> positions) override;
  nlohmann::json state() const override;
  void restore(const nlohmann::json& state) override;

 private:
  // Bubbles that are gone leave their volume to the one that has grown by it, new ones keep what they have.
  void follow(const lostopos::SurfaceMesh& mesh);
  void correct(const EffectStep& step, std::span<lostopos::Vec3> positions) const;

  std::map<lostopos::Region, double> wanted_;  // L³
};

}  // namespace foamsim
