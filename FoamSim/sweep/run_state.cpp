#include "FoamSim/sweep/run_state.h"

#include <array>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Base/io/atomic_file.h"
#include "Base/io/file_lock.h"

namespace foamsim::sweep {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

fs::path attempt_file(const fs::path& run_folder) {
  return run_folder / "state.json";
}

// A JSON object in a file; null where there is none.
json read_object(const fs::path& file) {
  std::ifstream in(file);
  if (!in) return nullptr;
  json value = json::parse(in, nullptr, false);
  return value.is_object() ? value : json::object();
}

std::string text_in(const json& value, const char* key) {
  return value.is_object() && value.contains(key) && value[key].is_string() ? value[key].get<std::string>()
                                                                            : std::string();
}

bool asks_to_stop(int signal) {
  return signal == SIGTERM || signal == SIGINT || signal == SIGHUP;
}

bool asked_to_stop(const Attempt& attempt) {
  return asks_to_stop(attempt.signal) ||
         (attempt.exit_code && asks_to_stop(static_cast<int>(*attempt.exit_code) - 128));
}

}  // namespace

const char* name(Status status) {
  constexpr std::array names{"pending", "queued", "running", "interrupted", "finished", "failed"};
  return names.at(static_cast<std::size_t>(status));
}

fs::path lock_file(const fs::path& run_folder) {
  return run_folder / "lock";
}

std::optional<Attempt> read_attempt(const fs::path& run_folder) {
  const json value = read_object(attempt_file(run_folder));
  if (value.is_null()) return std::nullopt;
  Attempt attempt;
  if (value.contains("exit_code") && value["exit_code"].is_number_integer())
    attempt.exit_code = value["exit_code"].get<long>();
  if (value.contains("signal") && value["signal"].is_number_integer()) attempt.signal = value["signal"].get<int>();
  attempt.message = text_in(value, "message");
  return attempt;
}

void write_attempt(const fs::path& run_folder, const Attempt& attempt) {
  const json exit_code = attempt.exit_code ? json(*attempt.exit_code) : json();
  const nlohmann::ordered_json value = {
      {"exit_code", exit_code}, {"signal", attempt.signal}, {"message", attempt.message}};
  base::AtomicFile file(attempt_file(run_folder));
  file.stream() << value.dump(2, ' ', false, json::error_handler_t::replace) << '\n';
  file.commit();
}

RunState recorded_state(const fs::path& run_folder) {
  const std::optional<Attempt> attempt = read_attempt(run_folder);
  if (!attempt) return {};
  const json run = read_object(run_folder / "run.json");
  const std::string ended = text_in(run, "ended");
  RunState state{Status::interrupted, attempt->exit_code, attempt->message};
  if (ended == "finished" || ended == "at rest" || ended == "not at rest") {
    // Also where whoever started it did not live to see it.
    state = {Status::finished, 0, text_in(run, "message")};
  } else if (ended == "failed") {
    state.status = Status::failed;
    state.message = text_in(run, "message");
  } else if (attempt->exit_code == 0 && run.is_null()) {
    state = {Status::finished, 0, {}};  // a study's row, which has no run.json
  } else if (attempt->exit_code && *attempt->exit_code != 0 && !asked_to_stop(*attempt)) {
    state.status = Status::failed;
  }
  return state;
}

RunState look_at(const fs::path& run_folder) {
  if (fs::exists(lock_file(run_folder)) && !base::FileLock::take(lock_file(run_folder)))
    return {Status::running, {}, {}};
  return recorded_state(run_folder);
}

}  // namespace foamsim::sweep
