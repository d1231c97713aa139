#pragma once

#include <functional>

#include "Base/error.h"

namespace base {

/// Work has been asked to stop before it was done. Whoever began it puts back what was there before.
class Interrupted : public Error {
 public:
  using Error::Error;
};

/// How long work hears that it is to stop: its loops call `check` every so often.
struct Interruption {
  std::function<bool()> asked = {};  ///< whether to stop; cheap, since it is asked often; empty: never

  /// Throws Interrupted where it has been asked to stop.
  void check() const {
    if (asked && asked()) throw Interrupted("interrupted");
  }
};

}  // namespace base
