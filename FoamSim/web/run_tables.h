#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace foamsim::web {

/// A table of numbers; an empty cell is NaN.
struct NumberTable {
  std::vector<std::string> columns;
  std::vector<std::vector<double>> rows;  ///< as many numbers as there are columns, each

  /// Number of the column, -1 where there is none of that name.
  int column(const std::string& name) const;
};

/// A row of events.csv.
struct RunEvent {
  long step;
  double time;  ///< T
  std::string kind, regions;
};

/// Reads a CSV file of numbers with a head line. A last line without its end is left out: it is being written. An
/// empty table where there is no such file. Throws base::InputError, with file and line, for a row of another length
/// or a cell that is not a number.
NumberTable read_numbers(const std::filesystem::path& file);

/// The same for events.csv.
std::vector<RunEvent> read_events(const std::filesystem::path& file);

/// At most `most` (>= 2) of `count` indices, evenly spread, the first and the last among them.
std::vector<std::size_t> spread_indices(std::size_t count, std::size_t most);

}  // namespace foamsim::web
