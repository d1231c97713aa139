#include "Base/io/csv_table.h"

#include <cerrno>
#include <cstring>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/io/write_error.h"

namespace base {

CsvTable::CsvTable(std::filesystem::path file, const std::string& header, bool append) : file_(std::move(file)) {
  const bool going_on = append && std::filesystem::exists(file_);
  if (going_on) whole_ = std::filesystem::file_size(file_);
  stream_.open(file_, going_on ? std::ios::app : std::ios::trunc);
  if (!stream_) throw_write_error("cannot write " + file_.string(), errno);
  if (!going_on) add(header + "\n");
}

void CsvTable::add(const std::string& rows) {
  errno = 0;
  stream_ << rows << std::flush;
  if (stream_) {
    whole_ += rows.size();
    return;
  }
  const int reason = errno;
  stream_.close();
  std::error_code ignored;
  std::filesystem::resize_file(file_, whole_, ignored);
  throw_write_error("cannot write " + file_.string(), reason);
}

std::vector<std::string> csv_cells_of(const std::string& line) {
  std::vector<std::string> cells(1);
  for (char c : line)
    if (c == ',')
      cells.emplace_back();
    else
      cells.back() += c;
  return cells;
}

void read_csv(const std::filesystem::path& file, const std::string& header,
              const std::function<void(const std::vector<std::string>& cells)>& row) {
  std::ifstream in(file);
  if (!in) throw FileError("cannot read " + file.string() + ": " + std::strerror(errno));
  const std::size_t columns = csv_cells_of(header).size();
  std::string line;
  for (int number = 1; std::getline(in, line); ++number) try {
      const std::vector<std::string> cells = csv_cells_of(line);
      if (number == 1 && line != header) throw InputError("the first line has to be '" + header + "'");
      if (cells.size() != columns)
        throw InputError("a row needs " + std::to_string(columns) + " cells, not " + std::to_string(cells.size()));
      if (number > 1) row(cells);
    } catch (const InputError& error) {
      throw InputError(file.string() + ":" + std::to_string(number) + ": " + error.what());
    }
}

void keep_rows_until(const std::filesystem::path& file, long last_step) {
  std::ifstream in(file);
  if (!in) return;
  AtomicFile out(file);
  std::string line;
  bool header = true;
  // A line without its end was cut off, and its step may be, too.
  while (std::getline(in, line) && !in.eof()) {
    if (!header && std::atol(line.c_str()) > last_step) break;
    out.stream() << line << '\n';
    header = false;
  }
  out.commit();
}

}  // namespace base
