#pragma once

#include <vector>

#include "LosTopos/mesh/handles.h"

namespace multitracker {

/// At which speed the film between two regions moves along its normal.
class PairSpeeds {
 public:
  /// `air`: the speed at which every region grows into the air, L/T. Films between others stand still until set.
  explicit PairSpeeds(double air = 0) : air_(air) {}

  /// Region `p` grows into `q` at this speed (L/T); so q grows into p at minus that.
  void set(lostopos::Region p, lostopos::Region q, double speed) { speeds_.push_back({p, q, speed}); }
  /// Of a triangle along its right-hand normal, which points out of labels.p into labels.q.
  double along_normal(lostopos::Labels labels) const;

 private:
  struct PairSpeed {
    lostopos::Region p, q;
    double speed;
  };
  double air_;
  std::vector<PairSpeed> speeds_;
};

}  // namespace multitracker
