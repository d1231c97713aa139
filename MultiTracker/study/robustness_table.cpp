#include "MultiTracker/study/robustness_table.h"

#include <algorithm>
#include <array>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/csv_cells.h"
#include "Base/io/csv_table.h"
#include "Base/io/number_text.h"

namespace multitracker {
namespace {

constexpr std::array verdicts{Verdict::success, Verdict::open, Verdict::failed, Verdict::late, Verdict::crashed};

const std::string& header() {
  static const std::string text =
      "spheres,step,seed,verdict,steps,shared_area,air_area,air_pockets,triangles,junction_edges,incomplete_vertices,"
      "snap_count,t1_count,cpu_seconds,peak_megabytes,message";
  return text;
}

// In the order of the columns behind the verdict.
std::array<double*, 11> numbers_of(RobustnessRun& run) {
  return {&run.steps,          &run.shared_area,         &run.air_area, &run.air_pockets, &run.triangles,
          &run.junction_edges, &run.incomplete_vertices, &run.snaps,    &run.separations, &run.cpu_seconds,
          &run.peak_megabytes};
}

double number_in(const std::string& cell) {
  const auto number = base::parse_double(cell);
  if (!number) throw base::InputError("'" + cell + "' is not a number");
  return *number;
}

long whole_in(const std::string& cell) {
  const auto number = base::parse_integer(cell);
  if (!number) throw base::InputError("'" + cell + "' is not a whole number");
  return static_cast<long>(*number);
}

Verdict verdict_in(const std::string& cell) {
  for (Verdict verdict : verdicts)
    if (cell == name(verdict)) return verdict;
  throw base::InputError("'" + cell + "' is not a verdict");
}

RobustnessRun run_from(const std::vector<std::string>& cells) {
  RobustnessRun run{.key = {whole_in(cells.at(0)), number_in(cells.at(1)), whole_in(cells.at(2))},
                    .verdict = verdict_in(cells.at(3))};
  std::size_t column = 4;
  for (double* number : numbers_of(run)) *number = number_in(cells.at(column++));
  run.message = cells.at(column);
  return run;
}

}  // namespace

const char* name(Verdict verdict) {
  constexpr std::array names{"success", "open", "failed", "late", "crashed"};
  return names.at(static_cast<std::size_t>(verdict));
}

std::string robustness_csv_row(const RobustnessRun& run) {
  RobustnessRun copy = run;
  base::CsvCells cells;
  cells.add(run.key.spheres).add(run.key.step).add(run.key.seed).add(std::string(name(run.verdict)));
  for (const double* number : numbers_of(copy)) cells.add(*number);
  return cells.add(run.message).line();
}

RobustnessRun robustness_run_from(const std::string& row) {
  const std::vector<std::string> cells = base::csv_cells_of(row.substr(0, row.find('\n')));
  if (cells.size() != base::csv_cells_of(header()).size()) throw base::InputError("'" + row + "' is not a row");
  return run_from(cells);
}

void write_robustness_table(const std::filesystem::path& file, const std::vector<RobustnessRun>& runs) {
  base::AtomicFile out(file, base::Durability::machine);
  out.stream() << header() << '\n';
  for (const RobustnessRun& run : runs) out.stream() << robustness_csv_row(run);
  out.commit();
}

std::vector<RobustnessRun> read_robustness_table(const std::filesystem::path& file) {
  std::vector<RobustnessRun> runs;
  base::read_csv(file, header(), [&](const std::vector<std::string>& cells) { runs.push_back(run_from(cells)); });
  return runs;
}

std::vector<RobustnessSummary> summarise(const std::vector<RobustnessRun>& runs) {
  std::vector<RobustnessSummary> summaries;
  for (const RobustnessRun& run : runs) {
    auto it = std::ranges::find_if(
        summaries, [&](const RobustnessSummary& s) { return s.spheres == run.key.spheres && s.step == run.key.step; });
    if (it == summaries.end()) it = summaries.insert(summaries.end(), {run.key.spheres, run.key.step});
    ++it->runs;
    it->peak_megabytes = std::max(it->peak_megabytes, run.peak_megabytes);
    if (!run.success()) continue;
    ++it->successes;
    it->shared_area += run.shared_area;
    it->cpu_seconds += run.cpu_seconds;
  }
  for (RobustnessSummary& summary : summaries) {
    const double count = static_cast<double>(std::max(1L, summary.successes));
    summary.shared_area /= count;
    summary.cpu_seconds /= count;
  }
  return summaries;
}

}  // namespace multitracker
