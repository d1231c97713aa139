#include "FoamSim/web/run_contents.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "FoamSim/web/read_text.h"

namespace foamsim::web {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

json read_description(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::is_directory(folder, ignored))
    throw base::InputError("'" + folder.string() + "' is not a folder; give that of a run, with run.json and frames/");
  const fs::path file = folder / "run.json";
  if (!fs::exists(file, ignored))
    throw base::InputError("'" + folder.string() + "' is not the folder of a run: it has no run.json");
  json value = json::parse(read_text(file), nullptr, false);
  if (!value.is_object()) throw base::InputError("'" + file.string() + "' is damaged: it is not a JSON object");
  return value;
}

std::string text_of(const json& value, const std::string& key) {
  const auto found = value.find(key);
  return found != value.end() && found->is_string() ? found->get<std::string>() : std::string();
}

// The step in "frame_000012.ply"; -1 for other names.
long step_of(const fs::path& file, const std::string& extension) {
  const std::string name = file.filename().string();
  constexpr std::string_view before = "frame_";
  if (!name.starts_with(before) || !name.ends_with(extension)) return -1;
  const char* const end = name.data() + name.size() - extension.size();
  long step = -1;
  const auto [last, error] = std::from_chars(name.data() + before.size(), end, step);
  return error == std::errc() && last == end ? step : -1;
}

std::map<long, fs::path> frames_in(const fs::path& folder, const std::string& extension) {
  std::map<long, fs::path> frames;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error))
    if (const long step = step_of(entry->path(), extension); step >= 0) frames[step] = entry->path();
  return frames;
}

// Times by step: from the table of metrics, and between its rows by the step's length.
class StepTimes {
 public:
  StepTimes(const NumberTable& metrics, const json& description) {
    const auto dt = description.find("dt");
    if (dt != description.end() && dt->is_number()) dt_ = dt->get<double>();
    const int step = metrics.column("step"), time = metrics.column("time");
    if (step < 0 || time < 0) return;
    for (const std::vector<double>& row : metrics.rows)
      times_[static_cast<long>(row[static_cast<std::size_t>(step)])] = row[static_cast<std::size_t>(time)];
  }

  double at(long step) const {
    const auto next = times_.upper_bound(step);
    if (next == times_.begin()) return static_cast<double>(step) * dt_;
    const auto& [known, time] = *std::prev(next);
    return time + static_cast<double>(step - known) * dt_;
  }

 private:
  std::map<long, double> times_;
  double dt_ = 1;
};

[[noreturn]] void refuse_gap(const fs::path& folder, long before, long after, long every) {
  throw base::InputError("'" + folder.string() + "' lacks frames between steps " + std::to_string(before) + " and " +
                         std::to_string(after) + ", where there is one every " + std::to_string(every) +
                         "; put back what is missing, or run it again");
}

long frame_distance(const json& description) {
  const auto options = description.find("options");
  if (options == description.end() || !options->is_object()) return 0;
  const auto every = options->find("frame_every");
  return every != options->end() && every->is_number_integer() ? every->get<long>() : 0;
}

std::vector<RunFrame> find_frames(const fs::path& folder, const json& description, const NumberTable& metrics) {
  const std::map<long, fs::path> surfaces = frames_in(folder / "frames", ".ply");
  const std::map<long, fs::path> with_fields = frames_in(folder / "vtp", ".vtp");
  const bool running = text_of(description, "ended") == "running";
  const long every = frame_distance(description);
  const StepTimes times(metrics, description);
  std::vector<RunFrame> frames;
  for (const auto& [step, file] : surfaces) {
    if (every > 0 && !frames.empty() && step - frames.back().step > every)
      refuse_gap(folder / "frames", frames.back().step, step, every);
    const auto fields = with_fields.find(step);
    if (!with_fields.empty() && fields == with_fields.end()) {
      if (running && file == surfaces.rbegin()->second) break;  // is being written
      throw base::InputError("'" + (folder / "vtp").string() + "' lacks the frame of step " + std::to_string(step) +
                             ", which frames/ has; put it back, or remove vtp/");
    }
    frames.push_back({step, times.at(step), file, fields == with_fields.end() ? fs::path() : fields->second});
  }
  if (frames.empty())
    throw base::InputError("'" + folder.string() + "' has no frames; a run writes them to frames/ as .ply");
  return frames;
}

}  // namespace

RunContents read_run(const fs::path& folder) {
  const json description = read_description(folder);
  RunContents run;
  run.scene = text_of(description, "scene");
  if (run.scene.empty()) run.scene = text_of(description, "mesh_file");
  run.command = text_of(description, "command");
  run.ended = text_of(description, "ended");
  run.metrics = read_numbers(folder / "metrics.csv");
  run.volumes = read_numbers(folder / "volumes.csv");
  run.events = read_events(folder / "events.csv");
  run.frames = find_frames(folder, description, run.metrics);
  return run;
}

}  // namespace foamsim::web
