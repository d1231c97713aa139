#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "FoamSim/app/commands.h"
#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/render/camera.h"
#include "FoamSim/render/render.h"
#include "LosTopos/io/surface_data.h"

namespace foamsim::app {

/// A surface to draw; what the data calls solid is hidden.
render::Surface to_draw(const lostopos::SurfaceData& data);

/// A sheet of pictures, a row a run's folder: `columns` (≥ 2) frames, the first, the last and others evenly between,
/// all seen by one camera, with the folder's name, the time and a scale. Throws as `lostopos::run::run_frames`.
void draw_frames(const std::vector<std::filesystem::path>& runs, std::size_t columns,
                 const std::filesystem::path& file);

/// A small picture of the films as they are, without solids, seen from `direction`.
void draw_films(const Simulation& simulation, const std::array<double, 3>& direction,
                const std::filesystem::path& file);

/// Runs one of the project's plot scripts on the CSV files of `folder`. False when no Python with matplotlib or no
/// script is found; `script` is its file name.
bool run_plot_script(const std::string& script, const std::filesystem::path& folder);

/// The same, with a warning on stderr when there is no plot.
void plot(const Program& program, const std::string& script, const std::filesystem::path& folder);

}  // namespace foamsim::app
