#include "FoamSim/sweep/sweep_folder.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/write_error.h"
#include "FoamSim/version.h"

namespace foamsim::sweep {

namespace fs = std::filesystem;
using nlohmann::json;
using nlohmann::ordered_json;

Sweep sweep_in(const fs::path& folder, Grid grid) {
  std::vector<PlannedRun> runs = plan_runs(grid);
  return sweep_in(folder, std::move(grid), std::move(runs));
}

Sweep sweep_in(const fs::path& folder, Grid grid, std::vector<PlannedRun> runs) {
  if (fs::exists(folder / "sweep.json")) {
    Sweep sweep = read_sweep(folder);
    if (sweep.grid != grid || sweep.runs != runs)
      throw base::InputError(folder.string() + " holds the sweep of another grid; give another folder with --out");
    return sweep;
  }
  if (fs::exists(folder) && !fs::is_directory(folder))
    throw base::InputError(folder.string() + " is a file; the output has to go to a folder");
  if (fs::exists(folder / "run.json"))
    throw base::InputError(folder.string() + " holds a run; give another folder with --out");
  return {fs::absolute(folder).lexically_normal(), std::move(grid), std::move(runs)};
}

Sweep read_sweep(const fs::path& folder) {
  const fs::path file = folder / "sweep.json";
  std::ifstream in(file);
  if (!in) throw base::InputError(folder.string() + " holds no sweep (there is no sweep.json)");
  try {
    const json value = json::parse(in);
    Sweep sweep{fs::absolute(folder).lexically_normal(), grid_from_json(value.at("grid")), {}};
    for (const json& one : value.at("runs"))
      sweep.runs.push_back({one.at("name").get<std::string>(), one.at("values").get<std::vector<std::string>>()});
    for (const json& one : value.at("submissions"))
      sweep.submissions.push_back({one.at("job_name").get<std::string>(), one.at("job").get<std::string>()});
    return sweep;
  } catch (const json::exception& error) {
    throw base::InputError(file.string() + " is damaged: " + error.what());
  }
}

void write_sweep(const Sweep& sweep) {
  base::make_folder(sweep.folder / "runs");
  ordered_json submissions = ordered_json::array(), runs = ordered_json::array();
  for (const Submission& one : sweep.submissions) submissions.push_back({{"job_name", one.job_name}, {"job", one.job}});
  for (const PlannedRun& run : sweep.runs) runs.push_back({{"name", run.name}, {"values", run.values}});
  const ordered_json value = {
      {"version", version}, {"grid", to_json(sweep.grid)}, {"submissions", submissions}, {"runs", runs}};
  base::AtomicFile file(sweep.record());
  file.stream() << value.dump(2) << '\n';
  file.commit();
}

}  // namespace foamsim::sweep
