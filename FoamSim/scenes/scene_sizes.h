#pragma once

#include <string>

#include "Base/options/option_spec.h"

namespace foamsim {

/// A whole number in a range, as a scene's own option.
base::OptionSpec whole_between(long least, long most, long default_value, std::string key, std::string summary);

/// Option `n` of scenes whose triangles are each divided into four n times.
base::OptionSpec subdivisions(long default_value, std::string summary, long least = 0);

/// A number whose magnitude is below a bound.
base::OptionSpec number_below(double bound, const std::string& bound_text, std::string key, double default_value,
                              std::string summary);

}  // namespace foamsim
