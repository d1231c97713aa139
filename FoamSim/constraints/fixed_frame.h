#pragma once

#include <vector>

#include "FoamSim/constraints/constraint.h"

namespace foamsim {

/// A frame that stands still: films end there, and its vertices stay where they are.
class FixedFrame final : public Constraint {
 public:
  /// `vertices`: those of the start mesh that it holds whole.
  explicit FixedFrame(std::vector<lostopos::Vertex> vertices) : vertices_(std::move(vertices)) {}
  std::string_view name() const override { return "frame"; }
  void attach(lostopos::SurfaceTracker& tracker) override;
  /// Every held coordinate of a vertex stays.
  void prescribe(const Stage& stage, std::span<lostopos::Vec3> positions) override;

 private:
  std::vector<lostopos::Vertex> vertices_;
};

}  // namespace foamsim
