#pragma once

#include "tests/support/run_program.h"

namespace foamsim::test {

using ::test::ProgramResult;
using ::test::read_file;
using ::test::ScratchFolder;

inline ProgramResult run_foamsim(const std::string& arguments, const std::string& before = "") {
  return ::test::run_program(FOAMSIM_PROGRAM, arguments, before);
}

}  // namespace foamsim::test
