#pragma once

#include <memory>

#include "FoamSim/scenes/catalogue.h"

namespace foamsim {

/// The foamsim program: reads the command line, does what it says, prints, and returns what main returns. For main.cpp,
/// and for programs of others that have the same commands.
/// `catalogue`: everything that can be named, with what such a program has added.
int run_program(int argc, char** argv, std::shared_ptr<const Catalogue> catalogue = built_in_catalogue());

}  // namespace foamsim
