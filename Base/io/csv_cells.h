#pragma once

#include <optional>
#include <string>

namespace base {

/// One line of a CSV file, cell by cell. Numbers have all their digits; in texts commas become semicolons and line
/// breaks blanks, so that no cell needs quotes.
class CsvCells {
 public:
  CsvCells& add(const std::string& text);
  CsvCells& add(double value);
  CsvCells& add(long value);
  /// An empty cell when there is no value.
  CsvCells& add(const std::optional<double>& value);
  /// The cells so far, with a newline.
  std::string line() const { return text_ + "\n"; }

 private:
  void begin_cell();

  std::string text_;
  bool first_ = true;
};

}  // namespace base
