#pragma once

#include "Base/error.h"

namespace lostopos {

/// A mesh operation was asked of elements that do not allow it (dead handle, degenerate triangle, equal labels).
class MeshError : public base::Error {
 public:
  using base::Error::Error;
};

/// The surface cannot be moved to where it is asked to go; it has been left where it was.
class MotionError : public base::Error {
 public:
  using base::Error::Error;
};

}  // namespace lostopos
