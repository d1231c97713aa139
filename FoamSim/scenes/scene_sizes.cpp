#include "FoamSim/scenes/scene_sizes.h"

#include <cmath>

namespace foamsim {

using base::OptionSpec;
using base::OptionValue;

OptionSpec whole_between(long least, long most, long default_value, std::string key, std::string summary) {
  return {std::move(key), default_value, std::move(summary),
          "a whole number from " + std::to_string(least) + " to " + std::to_string(most),
          [least, most](const OptionValue& value) {
            return std::get<long>(value) >= least && std::get<long>(value) <= most;
          }};
}

OptionSpec subdivisions(long default_value, std::string summary, long least) {
  // Beyond eight subdivisions (over a million triangles) direct summation would not end in a lifetime of patience.
  return whole_between(least, 8, default_value, "n", std::move(summary));
}

OptionSpec number_below(double bound, const std::string& bound_text, std::string key, double default_value,
                        std::string summary) {
  return {std::move(key), default_value, std::move(summary), "a number between -" + bound_text + " and " + bound_text,
          [bound](const OptionValue& value) { return std::abs(std::get<double>(value)) < bound; }};
}

}  // namespace foamsim
