#pragma once

#include <memory>

#include "MultiTracker/flows/flow.h"
#include "MultiTracker/flows/surface_flow.h"

namespace multitracker {

/// Carries a surface along with a velocity field, see `carried`. Held coordinates stay.
class PrescribedFlow final : public SurfaceFlow {
 public:
  explicit PrescribedFlow(std::unique_ptr<Flow> flow) : flow_(std::move(flow)) {}
  std::vector<lostopos::Vec3> predicted(const FlowStep& step) const override;

 private:
  std::unique_ptr<Flow> flow_;
};

}  // namespace multitracker
