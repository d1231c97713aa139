#include "FoamSim/web/export_web.h"

#include <map>

#include "Base/error.h"
#include "Base/interruption.h"
#include "Base/io/atomic_file.h"
#include "FoamSim/web/gzip.h"
#include "FoamSim/web/run_description.h"
#include "FoamSim/web/viewer_page.h"
#include "LosTopos/io/base64.h"

namespace foamsim::web {

namespace fs = std::filesystem;

namespace {

std::vector<RunFrame> every_nth(const std::vector<RunFrame>& frames, long every) {
  std::vector<RunFrame> chosen;
  for (std::size_t i = 0; i < frames.size(); i += static_cast<std::size_t>(every)) chosen.push_back(frames[i]);
  if (chosen.back().step != frames.back().step) chosen.push_back(frames.back());
  return chosen;
}

// Data as an element that the browser does not run, under a name.
std::string data_element(const std::string& name, const std::string& gzipped) {
  return "<script type=\"application/gzip\" data-name=\"" + name + "\">" + lostopos::base64_encode(gzipped) +
         "</script>\n";
}

// From the first frame, with the sizes of the others' files.
std::uintmax_t expected_size(const std::vector<RunFrame>& frames, std::size_t first_element, std::size_t page) {
  double ratio = 0;
  std::error_code ignored;
  const auto first = static_cast<double>(fs::file_size(frames.front().surface, ignored));
  for (const RunFrame& frame : frames) ratio += static_cast<double>(fs::file_size(frame.surface, ignored)) / first;
  return page + static_cast<std::uintmax_t>(ratio * static_cast<double>(first_element));
}

}  // namespace

ExportOutcome export_web(const fs::path& folder, const fs::path& file, std::string_view page,
                         const ExportOptions& options, const ExportHooks& hooks) {
  if (options.every < 1) throw base::InputError("every n-th frame: n has to be a whole number >= 1");
  RunContents run = read_run(folder);
  run.frames = every_nth(run.frames, options.every);
  const PageParts parts = split_page(page, run.scene);
  const base::Interruption interruption{hooks.interrupted};
  std::map<long, std::string> bubbles;
  const auto element_of = [&](const RunFrame& frame) {
    interruption.check();
    LoadedFrame loaded = load_frame(frame, options.frames);
    bubbles[frame.step] = std::move(loaded.bubbles);
    return data_element("frame/" + std::to_string(frame.step), loaded.packed);
  };

  std::string element = element_of(run.frames.front());
  if (hooks.begin) hooks.begin(expected_size(run.frames, element.size(), page.size()), run.frames.size());
  base::AtomicFile out(file);
  ExportOutcome outcome;
  const auto write = [&](const std::string& text) {
    out.stream() << text;
    outcome.bytes += text.size();
  };
  write(parts.before);
  for (const RunFrame& frame : run.frames) {
    if (outcome.frames > 0) element = element_of(frame);
    write(element);
    ++outcome.frames;
    if (hooks.frame_done) hooks.frame_done(outcome.frames, run.frames.size());
  }
  write(data_element("run", gzip(describe_run(run, bubbles))));
  write(parts.behind);
  out.commit();
  return outcome;
}

}  // namespace foamsim::web
