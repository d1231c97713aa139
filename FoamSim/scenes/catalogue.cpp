#include "FoamSim/scenes/catalogue.h"

namespace foamsim {

std::shared_ptr<const Catalogue> built_in_catalogue() {
  static const auto catalogue = std::make_shared<const Catalogue>();
  return catalogue;
}

}  // namespace foamsim
