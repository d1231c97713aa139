#pragma once

#include <cstddef>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "FoamSim/scenes/catalogue.h"

namespace foamsim::sweep {

/// An option and the values that it takes in turn, as --set has them.
struct Axis {
  std::string key;
  std::vector<std::string> values;
  bool operator==(const Axis&) const = default;
};

/// What a sweep runs: a scene with each combination of some options' values, or the rows of a study.
struct Grid {
  std::string scene;                    ///< as `run` takes it; a file by its absolute path
  std::string scene_hash = {};          ///< of that file's bytes; empty: a built-in scene
  std::vector<std::string> fixed = {};  ///< key=value, the same for all
  std::optional<double> time = {};      ///< where each run stops, as --time, --steps and --until-rest say
  std::optional<long> steps = {};
  bool until_rest = false;
  std::vector<Axis> axes = {};  ///< in the order of the file; not empty, and none of them is
  /// "accuracy": each run is a row of this study, and there is no scene. The axes are arguments of the study ("areas"
  /// for
  /// --areas), `fixed` are words of its command line, and its table is STUDY.csv in the run's folder.
  std::string study = {};
  bool operator==(const Grid&) const = default;
};

/// More runs than this are not counted.
inline constexpr std::size_t most_runs_counted = 1'000'000'000'000'000'000;

/// Reads a grid file (docs/sweeps.md) and checks the keys and each value by itself. Throws base::InputError with file
/// and line.
Grid read_grid(const std::string& file, std::shared_ptr<const Catalogue> catalogue);

/// The product of the axes' sizes, at most most_runs_counted; nothing is built.
std::size_t count_runs(const Grid& grid);

nlohmann::json to_json(const Grid& grid);
/// Throws nlohmann::json::exception where the value is no grid.
Grid grid_from_json(const nlohmann::json& value);

}  // namespace foamsim::sweep
