#pragma once

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>
#include <vector>

namespace base {

/// A CSV file that grows row by row. After an error it ends with the last whole row.
class CsvTable {
 public:
  /// Writes the header line, or goes on behind what `file` holds when `append`. Throws FileError,
  /// DiskError.
  CsvTable(std::filesystem::path file, const std::string& header, bool append = false);
  /// Adds one line (or several, each with its newline) and hands it to the system. Throws DiskError, e.g.
  /// when the disk is full; the part of a row that got through is cut off again.
  void add(const std::string& rows);

 private:
  std::filesystem::path file_;
  std::ofstream stream_;
  std::uintmax_t whole_ = 0;  // bytes up to the end of the last whole row
};

/// The cells of one line as they stand: nothing is quoted.
std::vector<std::string> csv_cells_of(const std::string& line);

/// Reads a whole table and hands on the cells of every row. Throws InputError with file and line when the first line is
/// not `header`, a row has another number of cells, or `row` throws one; FileError when the file cannot be read. Cells
/// are taken as they stand: nothing is quoted.
void read_csv(const std::filesystem::path& file, const std::string& header,
              const std::function<void(const std::vector<std::string>& cells)>& row);

/// Cuts a table back to the header and the rows whose first column, a step, is at most `last_step`; a
/// last line without its end goes, too.
void keep_rows_until(const std::filesystem::path& file, long last_step);

}  // namespace base
