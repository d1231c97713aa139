#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>

#include "FoamSim/constraints/selection.h"
#include "LosTopos/vec3.h"

namespace foamsim {

/// How a wire moves, and when; outside of that time it stands still.
struct WireMotion {
  enum class Kind { still, move, pull };

  Kind kind = Kind::still;
  lostopos::Vec3 velocity = lostopos::Vec3::Zero();  ///< of `move`, L/T
  double speed = 0;                                  ///< of `pull`: of each of the two groups, L/T
  /// Of `pull`: the direction in which the groups lie to each other, of length 1; nothing: from the mean of the one to
  /// that of the other.
  std::optional<lostopos::Vec3> axis = {};
  double from = 0;                                         ///< T
  double until = std::numeric_limits<double>::infinity();  ///< T

  /// How far a vertex with this velocity (L/T) goes between two times (T), L.
  lostopos::Vec3 displacement(const lostopos::Vec3& its_velocity, double start, double end) const;
};

/// A wire: which vertices, and how they move. As a text
///
///     SELECTION: MOTION [from T] [until T]
///
/// with a selection (see Selection) and a motion: `still`, `move VX VY VZ` (velocity, L/T), or `pull SPEED [along x|y|z
/// or AX AY AZ]`, by which two groups go apart, each with the speed (L/T).
struct WireSpec {
  Selection selection;
  WireMotion motion;

  /// Throws base::InputError that quotes the text and says what would be right.
  explicit WireSpec(std::string_view text);
  /// The text in its shortest form; parsed again it means the same.
  std::string text() const;
};

}  // namespace foamsim
