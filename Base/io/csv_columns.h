#pragma once

#include <optional>
#include <span>
#include <string>

#include "Base/options/option_value.h"

namespace base {

/// A number as a cell: all digits; empty where there is none.
inline std::string cell_text(double number) {
  return to_text(number);
}
inline std::string cell_text(long number) {
  return std::to_string(number);
}
inline std::string cell_text(std::size_t number) {
  return std::to_string(number);
}
inline std::string cell_text(const std::optional<double>& number) {
  return number ? to_text(*number) : std::string();
}

/// A column of a table whose rows are each made from one `Record`.
template <class Record>
struct CsvColumn {
  const char* name;
  std::string (*text)(const Record&);
};

/// The names, separated by commas.
template <class Record>
std::string csv_header(std::span<const CsvColumn<Record>> columns) {
  std::string header;
  for (const auto& column : columns) header += (header.empty() ? "" : ",") + std::string(column.name);
  return header;
}

/// One line, with its newline.
template <class Record>
std::string csv_row(std::span<const CsvColumn<Record>> columns, const Record& record) {
  std::string row;
  for (const auto& column : columns) row += (&column == &columns.front() ? "" : ",") + column.text(record);
  return row + "\n";
}

}  // namespace base
