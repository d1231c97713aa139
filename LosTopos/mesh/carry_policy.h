#pragma once

#include <span>
#include <vector>

#include "LosTopos/mesh/operation_events.h"

namespace lostopos {

/// How the values of one named attribute follow the operations: derive from it for a rule of one's own, override the
/// hooks of OperationObserver that matter, and hand an object to SurfaceMesh::add_vertex_attribute. In the `before_`
/// hooks values may be read only (other attributes and observers see them as they were), in the `after_` hooks they may
/// be written; elements that the event calls gone still have theirs. An element that no hook writes to has its own
/// value when it was there before, else the attribute's initial one.
template <class H, class T>
class CarryPolicy : public OperationObserver {
 public:
  /// Called by the attribute: what `value` and `values` give.
  void bind(std::vector<T>& values) { values_ = &values; }

 protected:
  T& value(H h) const { return (*values_)[h.index()]; }
  /// All slots.
  std::span<T> values() const { return *values_; }

 private:
  std::vector<T>* values_ = nullptr;
};

}  // namespace lostopos
