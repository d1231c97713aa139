#pragma once

#include <string>

#include "Base/error.h"

namespace foamsim {

/// Throws base::InputError, saying `what`, unless the options of a study are right.
inline void require(bool right, const char* what) {
  if (!right) throw base::InputError(what);
}

}  // namespace foamsim
