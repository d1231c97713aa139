#include "FoamSim/statistics/run_statistics.h"

#include <list>

#include "Base/error.h"
#include "Base/interruption.h"
#include "Base/io/atomic_file.h"
#include "Base/io/write_error.h"
#include "LosTopos/io/film_faces.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/run/run_frames.h"

namespace foamsim {

namespace fs = std::filesystem;

using lostopos::run::RunFrame;

namespace {

FrameStatistics count_frame(const RunFrame& frame) {
  const lostopos::SurfaceData data = lostopos::read_surface(frame.file);
  return {frame.step, frame.time, foam_statistics(lostopos::to_mesh(data), lostopos::solid_triangles(data))};
}

std::vector<RunFrame> chosen_frames(const RunStatisticsOptions& options) {
  std::vector<RunFrame> frames = lostopos::run::run_frames(options.run);
  if (!options.step) return frames;
  for (const RunFrame& frame : frames)
    if (frame.step == *options.step) return {frame};
  throw base::InputError(options.run.string() + " has no frame of step " + std::to_string(*options.step) +
                         "; the last is of step " + std::to_string(frames.back().step));
}

// The tables, under way until all frames are counted.
class Tables {
 public:
  explicit Tables(const fs::path& folder) {
    for (const Kind& kind : kinds) files_.emplace_back(folder / kind.file).stream() << kind.header();
  }
  void add(const FrameStatistics& frame) {
    auto file = files_.begin();
    for (const Kind& kind : kinds) (file++)->stream() << kind.rows(frame);
  }
  void commit() {
    for (base::AtomicFile& file : files_) file.commit();
  }

 private:
  struct Kind {
    const char* file;
    std::string (*header)();
    std::string (*rows)(const FrameStatistics&);
  };
  static constexpr std::array kinds{
      Kind{"foam.csv", foam_table_header, foam_table_row},
      Kind{"bubbles.csv", bubble_table_header, bubble_table_rows},
      Kind{"films.csv", film_table_header, film_table_rows},
      Kind{"distributions.csv", distribution_table_header, distribution_table_rows},
  };
  std::list<base::AtomicFile> files_;
};

FrameStatistics write_tables(const std::vector<RunFrame>& frames, const std::optional<RunEvents>& events,
                             const RunStatisticsOptions& options) {
  Tables tables(options.out);
  FrameStatistics last;
  for (std::size_t i = 0; i < frames.size(); ++i) {
    if (options.interrupted && options.interrupted()) throw base::Interrupted("interrupted");
    FrameStatistics now = count_frame(frames[i]);
    if (i > 0) {
      now.since = last.time;
      if (events) now.events = events->between(last.step, now.step);
    }
    last = std::move(now);
    tables.add(last);
    if (options.counted) options.counted(last, static_cast<double>(i + 1) / static_cast<double>(frames.size()));
  }
  tables.commit();
  return last;
}

}  // namespace

FrameStatistics write_run_statistics(const RunStatisticsOptions& options) {
  const std::vector<RunFrame> frames = chosen_frames(options);
  std::optional<RunEvents> events;
  if (const fs::path file = options.run / "events.csv"; fs::exists(file)) events.emplace(file);
  const bool made = !fs::exists(options.out);
  base::make_folder(options.out);
  try {
    return write_tables(frames, events, options);
  } catch (...) {
    std::error_code ignored;
    if (made) fs::remove(options.out, ignored);
    throw;
  }
}

}  // namespace foamsim
