#include "LosTopos/io/csv_table.h"

#include <cerrno>
#include <cstring>

#include "LosTopos/error.h"
#include "LosTopos/io/atomic_file.h"

namespace lostopos {

CsvTable::CsvTable(std::filesystem::path file, const std::string& header, bool append) : file_(std::move(file)) {
  const bool going_on = append && std::filesystem::exists(file_);
  if (going_on) whole_ = std::filesystem::file_size(file_);
  stream_.open(file_, going_on ? std::ios::app : std::ios::trunc);
  if (!stream_) throw FileError("cannot write " + file_.string() + ": " + std::strerror(errno));
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
  throw FileError("cannot write " + file_.string() + ": " +
                  (reason != 0 ? std::strerror(reason) : "the disk may be full"));
}

void keep_rows_until(const std::filesystem::path& file, long last_step) {
  std::ifstream in(file);
  if (!in) return;
  AtomicFile out(file);
  std::string line;
  bool header = true;
  while (std::getline(in, line)) {
    if (!header && std::atol(line.c_str()) > last_step) break;
    out.stream() << line << '\n';
    header = false;
  }
  out.commit();
}

}  // namespace lostopos
