#pragma once

#include <optional>

#include "LosTopos/collision/contact.h"
#include "LosTopos/collision/motion.h"

namespace lostopos {

/// Distances that decide, L.
struct ContactScale {
  double proximity = 0;  ///< ε_c
  /// Pairs that provably stay farther apart than this during the whole motion are not looked at more closely. At least
  /// proximity, and large against the rounding error of a distance.
  double safe = 0;
  /// Below it a pair may not come nearer than half its distance at the start, or else gaps would shrink until
  /// collision detection cannot tell them from contact.
  double least_gap = 0;
};

struct PairResult {
  std::optional<Contact> proximity;  ///< nearer than ε_c at the start
  std::optional<Contact> collision;  ///< on the way, or too near at its end
};

/// Looks at one pair's motion. No collision means none, as for vertex_triangle_collision and edge_edge_collision.
PairResult test_pair(const Motion& motion, const ElementPair& pair, const ContactScale& scale);

}  // namespace lostopos
