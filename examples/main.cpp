#include <FoamSim/app/run_program.h>

#include "models.h"

// foamsim with three models more: they are listed, completed, checked, run and resumed like its own.
int main(int argc, char** argv) {
  auto catalogue = std::make_shared<foamsim::Catalogue>(*foamsim::built_in_catalogue());
  catalogue->scenes.add(egg_scene());
  catalogue->sheet.areas.add(smallest_area());
  catalogue->effects.add(wind());
  return foamsim::run_program(argc, argv, std::move(catalogue));
}
