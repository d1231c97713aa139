#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "tests/support/scratch_folder.h"

namespace test {

struct ProgramResult {
  int exit_code;
  std::string out, error;
};

/// Runs a program through a shell with these arguments; `before` is put in front of it (ulimit …;).
ProgramResult run_program(const std::string& program, const std::string& arguments, const std::string& before = "");

std::string read_file(const std::filesystem::path& file);

/// A command line that has to be refused.
struct BadCase {
  std::string name, arguments;
  std::vector<std::string> message_has;  ///< parts of the message
};

void PrintTo(const BadCase& bad, std::ostream* out);  // NOLINT(readability-identifier-naming): GoogleTest's name

/// Runs the program with the case's arguments and an output folder: one line that has the parts, exit 2, no folder.
void expect_refused(const std::string& program, const BadCase& bad);

}  // namespace test
