#pragma once

#include <filesystem>
#include <vector>

#include "FoamSim/studies/modes/mode_oscillation.h"

namespace foamsim {

/// The amplitudes of all runs over time: columns mode, triangles, time, measured, theory. Throws base::FileError.
void write_mode_csv(const std::filesystem::path& file, const std::vector<ModeConvergence>& results);

/// One row a run, and one with 0 triangles and δ = 0 for what is extrapolated from them: columns mode, triangles,
/// resolution, delta, dt, omega, omega_theory, frequency_error, period_error, order, energy_drift, impulse_ratio;
/// fields that a row does not have are empty. Throws base::FileError.
void write_mode_summary_csv(const std::filesystem::path& file, const std::vector<ModeConvergence>& results);

}  // namespace foamsim
