#include "MultiTracker/flows/rotation.h"

#include <numbers>

namespace multitracker {

double RotationFlow::period() const {
  return 2 * std::numbers::pi;
}

}  // namespace multitracker
