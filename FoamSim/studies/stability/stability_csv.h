#pragma once

#include <string>

#include "FoamSim/studies/stability/stability_study.h"

namespace foamsim {

/// The header line of stability.csv.
std::string stability_csv_header();
/// A line of it, with its newline. Commas and line breaks in reasons become semicolons and blanks.
std::string stability_csv_row(const StabilityRow& row);

}  // namespace foamsim
