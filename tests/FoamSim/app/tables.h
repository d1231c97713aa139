#pragma once

#include <sstream>
#include <string>
#include <vector>

namespace foamsim::test {

/// A table without its columns of wall times, which differ from run to run where all others have to be the same;
/// and without the column `also`.
inline std::string without_seconds(const std::string& table, const std::string& also = "") {
  std::istringstream in(table);
  std::string result;
  std::vector<bool> kept;
  for (std::string line; std::getline(in, line);) {
    std::istringstream cells(line);
    std::string cell;
    const bool header = kept.empty();
    for (std::size_t column = 0; std::getline(cells, cell, ','); ++column) {
      if (header) kept.push_back(!cell.ends_with("_seconds") && cell != also);
      if (kept[column]) result += cell + ",";
    }
    result += "\n";
  }
  return result;
}

}  // namespace foamsim::test
