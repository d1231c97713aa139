#include "FoamSim/web/run_tables.h"

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>

#include "Base/error.h"
#include "Base/io/csv_table.h"
#include "FoamSim/web/read_text.h"

namespace foamsim::web {

namespace fs = std::filesystem;
using Cells = std::vector<std::string>;

namespace {

[[noreturn]] void refuse_line(const fs::path& file, std::size_t line, const std::string& problem) {
  throw base::InputError(file.string() + ", line " + std::to_string(line) + ": " + problem);
}

// Hands on head and rows, each with its line.
void read_whole_lines(const fs::path& file, const std::function<void(const Cells&, std::size_t)>& take) {
  std::error_code ignored;
  if (!fs::exists(file, ignored)) return;
  const std::string text = read_text(file);
  std::size_t line = 0, cells = 0;
  for (std::size_t begin = 0, end = 0; (end = text.find('\n', begin)) != std::string::npos; begin = end + 1) {
    const Cells row = base::csv_cells_of(text.substr(begin, end - begin));
    if (++line == 1) cells = row.size();
    if (row.size() != cells)
      refuse_line(file, line, std::to_string(row.size()) + " cells in place of " + std::to_string(cells));
    take(row, line);
  }
}

double number_of(const std::string& cell, const fs::path& file, std::size_t line) {
  double value = std::numeric_limits<double>::quiet_NaN();
  if (cell.empty()) return value;
  const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
  if (error != std::errc() || end != cell.data() + cell.size())
    refuse_line(file, line, "'" + cell.substr(0, 40) + "' is not a number");
  return value;
}

}  // namespace

int NumberTable::column(const std::string& name) const {
  const auto found = std::ranges::find(columns, name);
  return found == columns.end() ? -1 : static_cast<int>(found - columns.begin());
}

NumberTable read_numbers(const fs::path& file) {
  NumberTable table;
  read_whole_lines(file, [&](const Cells& cells, std::size_t line) {
    if (line == 1) {
      table.columns = cells;
      return;
    }
    std::vector<double>& row = table.rows.emplace_back();
    for (const std::string& cell : cells) row.push_back(number_of(cell, file, line));
  });
  return table;
}

std::vector<RunEvent> read_events(const fs::path& file) {
  std::vector<RunEvent> events;
  read_whole_lines(file, [&](const Cells& cells, std::size_t line) {
    if (cells.size() < 4) refuse_line(file, line, "step, time, kind and regions are wanted");
    if (line > 1)
      events.push_back(
          {static_cast<long>(number_of(cells[0], file, line)), number_of(cells[1], file, line), cells[2], cells[3]});
  });
  return events;
}

std::vector<std::size_t> spread_indices(std::size_t count, std::size_t most) {
  std::vector<std::size_t> indices;
  const std::size_t wanted = std::min(count, most);
  for (std::size_t i = 0; i < wanted; ++i) indices.push_back(wanted == 1 ? 0 : i * (count - 1) / (wanted - 1));
  return indices;
}

}  // namespace foamsim::web
