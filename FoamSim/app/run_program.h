#pragma once

namespace foamsim {

/// The foamsim program: reads the command line, does what it says, prints, and returns what main returns. For main.cpp,
/// and for programs of others that have the same commands.
int run_program(int argc, char** argv);

}  // namespace foamsim
