#pragma once

#include <string_view>

namespace lostopos::test {

/// The value in assets/reference/equilibria.csv of a scene and of its one quantity that begins with `quantity`. Throws
/// std::runtime_error when there is no such row, or more than one.
double reference_value(std::string_view scene, std::string_view quantity);

}  // namespace lostopos::test
