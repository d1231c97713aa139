#include "FoamSim/app/run_program.h"

int main(int argc, char** argv) {
  return foamsim::run_program(argc, argv);
}
