#include "MultiTracker/run/run_json.h"

#include <tbb/global_control.h>

#include <nlohmann/json.hpp>
#include <variant>

#include "Base/io/atomic_file.h"

namespace multitracker {

using nlohmann::ordered_json;

namespace {

ordered_json refusals(const lostopos::OperationCounts& counts) {
  ordered_json reasons = ordered_json::object();
  for (std::size_t i = 0; i < lostopos::refusal_count; ++i)
    if (counts.refused[i] > 0) reasons[lostopos::name(static_cast<lostopos::Refusal>(i))] = counts.refused[i];
  return reasons;
}

template <class Operation, class Statistics>
ordered_json operations(const Statistics& statistics) {
  ordered_json all = ordered_json::object();
  for (std::size_t i = 0; i < statistics.operations.size(); ++i) {
    const lostopos::OperationCounts& counts = statistics.operations[i];
    all[lostopos::name(static_cast<Operation>(i))] = {
        {"done", counts.done}, {"seconds", counts.seconds}, {"refused", refusals(counts)}};
  }
  return all;
}

ordered_json state(const Metrics& m) {
  return {{"step", m.step},
          {"time", m.time},
          {"triangles", m.triangles},
          {"regions", m.regions},
          {"area", m.area},
          {"shared_area", m.shared_area},
          {"air_area", m.air_area},
          {"junction_edges", m.junction_edges},
          {"volume_drift_max", m.volume_drift_max}};
}

ordered_json all_options(const base::OptionSet& options) {
  ordered_json all = ordered_json::object();
  for (const base::OptionSpec& spec : options.specs())
    std::visit([&](const auto& value) { all[spec.key] = value; }, options.value(spec.key));
  return all;
}

}  // namespace

void write_run_json(const std::filesystem::path& file, const RunCall& call, const base::OptionSet& options,
                    const RunOutcome& outcome) {
  const ordered_json value{{"version", call.version},
                           {"command", call.command},
                           {"scene", call.scene},
                           {"mesh_file", call.mesh_file},
                           {"options", all_options(options)},
                           {"threads", tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism)},
                           {"ended", name(outcome.end)},
                           {"message", outcome.message},
                           {"start", state(outcome.start)},
                           {"last", state(outcome.last)},
                           {"wall_seconds", outcome.wall_seconds},
                           {"topology", operations<lostopos::TopologyOperation>(outcome.topology)},
                           {"incomplete_vertices", outcome.topology.incomplete_vertices},
                           {"remeshing", operations<lostopos::Operation>(outcome.remesh)},
                           {"last_frame", outcome.last_frame.filename().string()}};
  base::AtomicFile out(file);
  out.stream() << value.dump(2) << '\n';
  out.commit();
}

}  // namespace multitracker
