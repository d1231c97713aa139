#include "FoamSim/web/server/run_pages.h"

#include <algorithm>
#include <charconv>
#include <exception>

#include "Base/error.h"
#include "FoamSim/web/run_description.h"

namespace foamsim::web {

namespace fs = std::filesystem;

namespace {

constexpr std::size_t most_kept = 16;
constexpr std::string_view frame_path = "frame/";

// The step in "frame/12"; -1 for other paths.
long step_in(const std::string& path) {
  if (!path.starts_with(frame_path)) return -1;
  const char* const end = path.data() + path.size();
  long step = -1;
  const auto [last, error] = std::from_chars(path.data() + frame_path.size(), end, step);
  return error == std::errc() && last == end ? step : -1;
}

}  // namespace

RunPages::RunPages(fs::path folder, std::string_view page, FrameOptions options)
    : folder_(std::move(folder)), options_(std::move(options)), run_(read_run(folder_)) {
  page_ = split_page(page, run_.scene);
  frame(run_.frames.front().step);
}

std::string RunPages::frame(long step) {
  const auto found = std::ranges::find(run_.frames, step, &RunFrame::step);
  if (found == run_.frames.end()) return {};
  const fs::path& file = found->with_fields.empty() ? found->surface : found->with_fields;
  std::error_code ignored;
  const fs::file_time_type written = fs::last_write_time(file, ignored);
  for (auto kept = kept_.begin(); kept != kept_.end(); ++kept)
    if (kept->step == step && kept->written == written) {
      kept_.splice(kept_.begin(), kept_, kept);
      return kept->packed;
    }
  LoadedFrame loaded = load_frame(*found, options_);
  bubbles_[step] = std::move(loaded.bubbles);
  kept_.remove_if([step](const KeptFrame& kept) { return kept.step == step; });
  kept_.push_front({step, written, std::move(loaded.packed)});
  if (kept_.size() > most_kept) kept_.pop_back();
  return kept_.front().packed;
}

WebAnswer RunPages::answer(const std::string& path) {
  try {
    if (path.empty())
      return {200, "text/html; charset=utf-8", page_.before + "<meta name=\"foamsim-live\">" + page_.behind};
    if (path == "run.json") {
      run_ = read_run(folder_);
      return {200, "application/json", describe_run(run_, bubbles_)};
    }
    if (const long step = step_in(path); step >= 0)
      if (std::string packed = frame(step); !packed.empty())
        return {200, "application/octet-stream", std::move(packed)};
  } catch (const base::Error& error) {
    return {500, "text/plain; charset=utf-8", std::string(error.what()) + "\n"};
  }
  return {404, "text/plain; charset=utf-8", "not found\n"};
}

}  // namespace foamsim::web
