#pragma once

#include <string>

namespace foamsim::test {

/// Expects `measured` within the stored tolerance of the stored value of `quantity` (tests/regression/reference.csv);
/// fails with old value, new value and tolerance. With FOAMSIM_REFRESH_REFERENCE set in the environment the measured
/// value is stored instead; tolerances and published values stay.
void expect_stored(const std::string& quantity, double measured);

}  // namespace foamsim::test
