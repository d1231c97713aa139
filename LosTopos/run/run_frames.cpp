#include "LosTopos/run/run_frames.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "Base/error.h"
#include "Base/json/checked_json.h"

namespace lostopos::run {

namespace fs = std::filesystem;

namespace {

// What run.json says of the frames.
struct Record {
  bool ended = false;
  long first_step = 0;  // from which it was taken up last
  long last_step = 0;
  double dt = 0;
  long frame_every = 0;  // 0: first and last alone
};

nlohmann::json read_run_json(const fs::path& run) {
  const fs::path file = run / "run.json";
  if (!fs::is_directory(run)) throw base::InputError(run.string() + " is no folder of a run: there is no such folder");
  std::ifstream in(file);
  if (!in) throw base::InputError(run.string() + " is no folder of a run: it has no run.json");
  nlohmann::json value = nlohmann::json::parse(in, nullptr, false);
  if (!value.is_object()) throw base::InputError(file.string() + " is not what a run writes there: no JSON object");
  return value;
}

Record record_of(const nlohmann::json& value, const fs::path& run) {
  const base::CheckedJson json(value, (run / "run.json").string());
  Record record;
  record.ended = json.at("ended").text() != "running";
  record.first_step = static_cast<long>(json.at("first_step").whole_number());
  record.last_step = static_cast<long>(json.at("last_step").whole_number());
  if (json.has("dt"))
    record.dt = json.at("dt").positive_number();
  else if (record.last_step > 0)
    record.dt = json.at("time").finite_number() / static_cast<double>(record.last_step);
  if (json.has("options") && json.at("options").has("frame_every"))
    record.frame_every = static_cast<long>(json.at("options").at("frame_every").whole_number());
  return record;
}

// The step of frame_000040.ply; nothing for other names.
std::optional<long> step_of(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::string_view begin = "frame_", end = ".ply";
  if (!name.starts_with(begin) || !name.ends_with(end) || name.size() <= begin.size() + end.size()) return std::nullopt;
  const char* last = name.data() + name.size() - end.size();
  long step = 0;
  const auto [stop, error] = std::from_chars(name.data() + begin.size(), last, step);
  if (error != std::errc() || stop != last || step < 0) return std::nullopt;
  return step;
}

std::vector<RunFrame> frames_in(const fs::path& folder, double dt) {
  std::vector<RunFrame> frames;
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (const auto step = step_of(entry.path()))
      frames.push_back({*step, dt * static_cast<double>(*step), entry.path()});
  std::ranges::sort(frames, {}, &RunFrame::step);
  return frames;
}

void require_all(const std::vector<RunFrame>& frames, const Record& record, const fs::path& folder) {
  const auto require = [&](long step) {
    if (std::ranges::binary_search(frames, step, {}, &RunFrame::step)) return;
    throw base::InputError(folder.string() + " lacks the frame of step " + std::to_string(step) +
                           ", which run.json says was written (frame_every=" + std::to_string(record.frame_every) +
                           ", " + std::to_string(record.last_step) + " steps)");
  };
  // A run that was taken up in another folder has none there of before.
  const long first = std::min(frames.front().step, record.first_step);
  const long last = record.ended ? record.last_step : frames.back().step;
  if (first == 0) require(0);
  if (record.frame_every > 0)
    for (long step = first - first % record.frame_every; step <= last - record.frame_every; step += record.frame_every)
      require(step + record.frame_every);
  if (record.ended) require(last);
}

}  // namespace

std::vector<RunFrame> run_frames(const fs::path& run) {
  const Record record = record_of(read_run_json(run), run);
  const fs::path folder = run / "frames";
  std::vector<RunFrame> frames = frames_in(folder, record.dt);
  if (frames.empty()) throw base::InputError(folder.string() + " has no frames, frame_000000.ply and on");
  require_all(frames, record, folder);
  return frames;
}

}  // namespace lostopos::run
