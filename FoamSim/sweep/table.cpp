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

// The cells of the last row that is whole, by column; empty where there is none.
std::map<std::string, std::string> last_row(const fs::path& file) {
  std::ifstream in(file);
  std::string line;
  if (!std::getline(in, line)) return {};
  const std::vector<std::string> columns = base::csv_cells_of(line);
  std::vector<std::string> last;
  while (std::getline(in, line) && !in.eof())
    if (auto cells = base::csv_cells_of(line); cells.size() == columns.size()) last = std::move(cells);
  std::map<std::string, std::string> row;
  for (std::size_t i = 0; i < last.size(); ++i) row[columns[i]] = last[i];
  return row;
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
  const std::vector<std::string> figures = base::csv_cells_of(metrics_header());
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
    const auto row = last_row(sweep.run_folder(run) / "metrics.csv");
    for (const std::string& figure : figures) {
      const auto cell = row.find(figure);
      cells.add(cell == row.end() ? std::string() : cell->second);
    }
    file.stream() << cells.line();
  }
  file.commit();
}

}  // namespace foamsim::sweep
