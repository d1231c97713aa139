#include "LosTopos/run/run_json.h"

#include <tbb/global_control.h>

#include <fstream>
#include <nlohmann/json.hpp>
#include <thread>

#include "Base/io/atomic_file.h"

namespace lostopos::run {

using nlohmann::ordered_json;

namespace {

std::string cpu_model() {
  std::ifstream info("/proc/cpuinfo");
  std::string line;
  while (std::getline(info, line))
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

ordered_json times_json(const base::StageTimes& times) {
  ordered_json stages = ordered_json::object();
  for (const auto& [stage, seconds] : times.stages()) stages[stage] = seconds;
  return stages;
}

ordered_json by_reason(const std::array<std::size_t, refusal_count>& counts) {
  ordered_json reasons = ordered_json::object();
  for (std::size_t i = 0; i < refusal_count; ++i)
    if (counts[i] > 0) reasons[name(static_cast<Refusal>(i))] = counts[i];
  return reasons;
}

// What was done, and refused by reason, for each of the operations that the kind numbers.
template <class Kind, std::size_t count>
ordered_json operations_json(const std::array<OperationCounts, count>& operations) {
  ordered_json value = ordered_json::object();
  for (std::size_t i = 0; i < count; ++i)
    value[name(static_cast<Kind>(i))] = {{"done", operations[i].done},
                                         {"seconds", operations[i].seconds},
                                         {"refused", by_reason(operations[i].refused)}};
  return value;
}

// With the edges that stayed out of bounds by the reason why.
ordered_json remeshing_json(const RemeshStatistics& statistics) {
  ordered_json value = operations_json<Operation>(statistics.operations);
  value["edges_left_too_long"] = by_reason(statistics.too_long.refused);
  value["edges_left_too_short"] = by_reason(statistics.too_short.refused);
  return value;
}

// A block each for what was done and refused, by reason; and what is left of the last step.
ordered_json topology_json(const TopologyStatistics& statistics) {
  ordered_json value = operations_json<TopologyOperation>(statistics.operations);
  value["cancelled_triangles"] = statistics.cancelled_triangles;
  value["incomplete_vertices"] = statistics.incomplete_vertices;
  value["incomplete_by_refusal"] = by_reason(statistics.incomplete_by_refusal);
  value["seconds"] = statistics.seconds;
  return value;
}

ordered_json collisions_json(const MoveStatistics& m) {
  return {{"proximities", m.proximities},  {"collisions", m.collisions},
          {"impulses", m.impulses},        {"inelastic_zones", m.inelastic_zones},
          {"rigid_zones", m.rigid_zones},  {"largest_zone", m.largest_zone},
          {"halvings", m.halvings},        {"broad_phase_seconds", m.broad_phase_seconds},
          {"ccd_seconds", m.ccd_seconds},  {"impulse_seconds", m.impulse_seconds},
          {"zone_seconds", m.zone_seconds}};
}

}  // namespace

void write_run_json(const std::filesystem::path& file, const Output& output, const Motion& motion,
                    const std::string& ended, const Outcome& outcome) {
  ordered_json value = ordered_json::object();
  if (output.describe) output.describe(value);
  value["threads"] = tbb::global_control::active_value(tbb::global_control::max_allowed_parallelism);
  value["machine"] = {{"cpu", cpu_model()}, {"cores", std::thread::hardware_concurrency()}};
  value["ended"] = ended;
  value["message"] = outcome.message;
  value["first_step"] = outcome.first_step;
  value["last_step"] = motion.steps();
  value["time"] = motion.time();
  value["wall_seconds"] = outcome.wall_seconds;
  value["stage_seconds"] = times_json(outcome.work.times);
  value["remeshing"] = remeshing_json(outcome.work.remesh);
  value["topology"] = topology_json(outcome.work.topology);
  value["collisions"] = collisions_json(outcome.work.move);
  value["last_frame"] = outcome.last_frame.filename().string();
  motion.summarize(value);
  base::AtomicFile out(file, base::Durability::machine);
  out.stream() << value.dump(2) << '\n';
  out.commit();
}

}  // namespace lostopos::run
