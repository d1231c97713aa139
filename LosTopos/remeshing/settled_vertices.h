#pragma once

#include <optional>
#include <vector>

#include "LosTopos/mesh/handles.h"
#include "LosTopos/remeshing/refusal.h"

namespace lostopos {

/// Vertices that an operation has refused to move for what their triangles are, and nothing else: as long as these
/// stay, it would refuse again, and need not look.
class SettledVertices {
 public:
  /// Why v is left alone; nothing where it is to be looked at.
  std::optional<Refusal> refusal(Vertex v) const {
    return v.index() < refusals_.size() ? refusals_[v.index()] : std::nullopt;
  }
  void settle(Vertex v, Refusal why) {
    if (v.index() >= refusals_.size()) refusals_.resize(v.index() + 1);
    refusals_[v.index()] = why;
  }
  /// A triangle of v has changed, come or gone.
  void disturb(Vertex v) {
    if (v.index() < refusals_.size()) refusals_[v.index()].reset();
  }

 private:
  std::vector<std::optional<Refusal>> refusals_;
};

}  // namespace lostopos
