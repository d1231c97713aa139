#pragma once

#include <vector>

#include "FoamSim/sheet/circulation.h"
#include "LosTopos/remeshing/operation_events.h"

namespace foamsim {

/// Carries Γ through the tracker's operations (METHOD "Carrying data through an operation"). Split: the mean of the two
/// ends. Collapse: interpolated by where the result lies between the two vertices; a pair that only one of them had
/// comes from that one. A pair that a vertex gains from nowhere is the mean of the neighbours that hold it.
class CirculationTransfer final : public lostopos::OperationObserver {
 public:
  /// `circulation` must outlive this.
  explicit CirculationTransfer(CirculationField& circulation) : circulation_(circulation) {}

  void after_split(const lostopos::SurfaceMesh& mesh, const lostopos::SplitEvent& event) override;
  void before_collapse(const lostopos::SurfaceMesh& mesh, const lostopos::CollapseEvent& event) override;
  void after_collapse(const lostopos::SurfaceMesh& mesh, const lostopos::CollapseEvent& event) override;
  void after_flip(const lostopos::SurfaceMesh& mesh, const lostopos::FlipEvent& event) override;

 private:
  CirculationField& circulation_;
  std::vector<lostopos::Vertex> touched_;  // whose triangles a collapse changes
};

}  // namespace foamsim
