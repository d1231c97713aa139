#include "tests/support/run_program.h"

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace test {

namespace fs = std::filesystem;

std::string read_file(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

ProgramResult run_program(const std::string& program, const std::string& arguments, const std::string& before) {
  const ScratchFolder scratch;
  const std::string command =
      before + " " + program + " " + arguments + " >" + (scratch / "out") + " 2>" + (scratch / "error") + " </dev/null";
  const int status = std::system(command.c_str());
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return {code, read_file(scratch / "out"), read_file(scratch / "error")};
}

void PrintTo(const BadCase& bad, std::ostream* out) {
  *out << bad.name;
}

void expect_refused(const std::string& program, const BadCase& bad) {
  const ScratchFolder scratch;
  const ProgramResult result = run_program(program, bad.arguments + " --out " + (scratch / "run"));
  EXPECT_EQ(result.exit_code, 2) << result.error;
  EXPECT_EQ(std::ranges::count(result.error, '\n'), 1) << result.error;
  for (const std::string& part : bad.message_has) EXPECT_NE(result.error.find(part), std::string::npos) << result.error;
  EXPECT_FALSE(fs::exists(scratch.path() / "run"));
}

}  // namespace test
