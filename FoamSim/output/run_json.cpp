#include "FoamSim/output/run_json.h"

#include <tbb/global_control.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "FoamSim/output/options_json.h"
#include "FoamSim/version.h"
#include "LosTopos/io/atomic_file.h"

namespace foamsim {

using nlohmann::ordered_json;

namespace {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

ordered_json times_json(const StageTimes& times) {
  ordered_json stages = ordered_json::object();
  for (const auto& [stage, seconds] : times.stages()) stages[stage] = seconds;
  return stages;
}

}  // namespace

void write_run_json(const std::filesystem::path& file, const Scene& scene, const RunSettings& settings,
                    const RunOutcome& outcome) {
  const ordered_json value{{"version", version},
                           {"command", settings.command},
                           {"scene", scene.name},
                           {"mesh_file", scene.mesh_file},
                           {"options", options_to_json(scene.options)},
                           {"seed", scene.options.whole("seed")},
                           {"threads", tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)},
                           {"machine", {{"cpu", cpu_model()}, {"cores", std::thread::hardware_concurrency()}}},
                           {"ended", name(outcome.end)},
                           {"message", outcome.message},
                           {"first_step", outcome.first_step},
                           {"last_step", outcome.last.step},
                           {"time", outcome.last.time},
                           {"wall_seconds", outcome.wall_seconds},
                           {"stage_seconds", times_json(outcome.times)},
                           {"last_frame", outcome.last_frame.filename().string()}};
  lostopos::AtomicFile out(file);
  out.stream() << value.dump(2) << '\n';
  out.commit();
}

}  // namespace foamsim
