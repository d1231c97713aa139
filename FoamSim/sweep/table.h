#pragma once

#include "FoamSim/sweep/run_state.h"
#include "FoamSim/sweep/sweep_folder.h"

namespace foamsim::sweep {

/// Writes table.csv, whole or not at all: a row a run with the varied options' values, its state (one a run in
/// `states`), and figures of run.json and of the last row of metrics.csv; cells without a value are empty.
/// docs/sweeps.md lists the columns. Throws base::FileError.
void write_table(const Sweep& sweep, const std::vector<RunState>& states);

}  // namespace foamsim::sweep
