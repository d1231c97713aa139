#pragma once

#include <string>

#include "FoamSim/studies/accuracy/accuracy_study.h"

namespace foamsim {

/// The header line of accuracy.csv.
std::string accuracy_csv_header();
/// A line of it, with its newline; cells of what was not measured are empty.
std::string accuracy_csv_row(const AccuracyRow& row);

}  // namespace foamsim
