#pragma once

#include <array>
#include <filesystem>
#include <vector>

#include "FoamSim/app/commands.h"
#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/render/camera.h"
#include "FoamSim/render/render.h"

namespace foamsim::app {

/// Reads a frame (any mesh format) as a surface to draw; what the file calls solid is hidden. Throws base::InputError.
render::Surface read_frame(const std::filesystem::path& file);

/// Draws all surfaces with one camera that shows all of them, seen from `direction`.
std::vector<render::Image> draw_together(const std::vector<render::Surface>& surfaces,
                                         const render::RenderOptions& options, const Eigen::Vector3d& direction);

/// A sheet of pictures, a row a folder of frames: `columns` (≥ 2) frames, the first, the last and others evenly
/// between, all seen by one camera.
void draw_frames(const std::vector<std::filesystem::path>& folders, std::size_t columns,
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
