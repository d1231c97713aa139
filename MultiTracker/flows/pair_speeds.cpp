#include "MultiTracker/flows/pair_speeds.h"

namespace multitracker {

double PairSpeeds::along_normal(lostopos::Labels labels) const {
  for (const PairSpeed& known : speeds_) {
    if (known.p == labels.p && known.q == labels.q) return known.speed;
    if (known.p == labels.q && known.q == labels.p) return -known.speed;
  }
  if (labels.q == lostopos::air) return air_;
  return labels.p == lostopos::air ? -air_ : 0;
}

}  // namespace multitracker
