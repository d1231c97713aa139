#include "FoamSim/sweep/table.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "Base/io/atomic_file.h"
#include "Base/io/csv_cells.h"
#include "Base/io/csv_table.h"
#include "FoamSim/metrics/metrics_csv.h"

namespace foamsim::sweep {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

constexpr const char* figures_of_run_json[] = {"ended", "last_step", "wall_seconds"};

// The names of the columns, and the last row that is whole by column; both are empty where there is none.
struct EndsOfTable {
  std::vector<std::string> columns;
  std::map<std::string, std::string> last;
};

EndsOfTable ends_of(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) return {};
  EndsOfTable ends{base::csv_cells_of(line), {}};
  std::vector<std::string> last;
  while (std::getline(in, line) && !in.eof())
    if (auto cells = base::csv_cells_of(line); cells.size() == ends.columns.size()) last = std::move(cells);
  for (std::size_t i = 0; i < last.size(); ++i) ends.last[ends.columns[i]] = last[i];
  return ends;
}

// What a run's table has; of a study this is known once a run has written it.
std::vector<std::string> figures_of(const Sweep& sweep) {
  if (sweep.grid.study.empty()) return base::csv_cells_of(metrics_header());
  for (std::size_t run = 0; run < sweep.runs.size(); ++run)
    if (auto columns = ends_of(sweep.run_folder(run) / table_of_run(sweep.grid)).columns; !columns.empty())
      return columns;
  return {};
}

void add_run_json(const fs::path& file, base::CsvCells& cells) {
  std::ifstream in(file);
  const json run = json::parse(in, nullptr, false);
  for (const char* key : figures_of_run_json) {
    if (!run.is_object() || !run.contains(key))
      cells.add(std::string());
    else if (run[key].is_string())
      cells.add(run[key].get<std::string>());
    else
      cells.add(run[key].dump());
  }
}

}  // namespace

void write_table(const Sweep& sweep, const std::vector<RunState>& states) {
  const std::vector<std::string> figures = figures_of(sweep);
  base::CsvCells header;
  header.add(std::string("run"));
  for (const Axis& axis : sweep.grid.axes) header.add(axis.key);
  for (const char* column : {"status", "exit_code", "message"}) header.add(std::string(column));
  for (const char* column : figures_of_run_json) header.add(std::string(column));
  for (const std::string& figure : figures) header.add("last." + figure);
  base::AtomicFile file(sweep.table());
  file.stream() << header.line();
  for (std::size_t run = 0; run < sweep.runs.size(); ++run) {
    const RunState& state = states.at(run);
    base::CsvCells cells;
    cells.add(sweep.runs[run].name);
    for (const std::string& value : sweep.runs[run].values) cells.add(value);
    cells.add(std::string(name(state.status)));
    cells.add(state.exit_code ? std::to_string(*state.exit_code) : std::string());
    cells.add(state.message);
    add_run_json(sweep.run_folder(run) / "run.json", cells);
    const auto row = ends_of(sweep.run_folder(run) / table_of_run(sweep.grid)).last;
    for (const std::string& figure : figures) {
      const auto cell = row.find(figure);
      cells.add(cell == row.end() ? std::string() : cell->second);
    }
    file.stream() << cells.line();
  }
  file.commit();
}

}  // namespace foamsim::sweep
