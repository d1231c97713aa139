#include "tests/support/reference_values.h"

#include <fstream>
#include <optional>
#include <sstream>
#include <stdexcept>
#include <string>

namespace lostopos::test {

double reference_value(std::string_view scene, std::string_view quantity) {
  std::ifstream file(FOAMSIM_ASSETS_DIR "/reference/equilibria.csv");
  std::optional<double> found;
  for (std::string line; std::getline(file, line);) {
    std::istringstream cells(line);
    std::string row_scene, row_quantity, value;
    std::getline(cells, row_scene, ',');
    std::getline(cells, row_quantity, ',');
    std::getline(cells, value, ',');
    if (row_scene != scene || !row_quantity.starts_with(quantity)) continue;
    if (found) throw std::runtime_error(std::string(scene) + ": more than one quantity begins with " + row_quantity);
    found = std::stod(value);
  }
  if (!found) throw std::runtime_error("no reference value " + std::string(scene) + ", " + std::string(quantity));
  return *found;
}

}  // namespace lostopos::test
