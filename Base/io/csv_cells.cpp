#include "Base/io/csv_cells.h"

#include <algorithm>

#include "Base/io/number_text.h"

namespace base {

void CsvCells::begin_cell() {
  if (!first_) text_ += ',';
  first_ = false;
}

CsvCells& CsvCells::add(const std::string& text) {
  begin_cell();
  std::string plain = text;
  std::ranges::replace(plain, ',', ';');
  std::ranges::replace(plain, '\n', ' ');
  text_ += plain;
  return *this;
}

CsvCells& CsvCells::add(double value) {
  begin_cell();
  append_number(text_, value);
  return *this;
}

CsvCells& CsvCells::add(long value) {
  begin_cell();
  text_ += std::to_string(value);
  return *this;
}

CsvCells& CsvCells::add(const std::optional<double>& value) {
  if (value) return add(*value);
  begin_cell();
  return *this;
}

}  // namespace base
