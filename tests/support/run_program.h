#pragma once

#include <filesystem>
#include <string>

namespace test {

struct ProgramResult {
  int exit_code;
  std::string out, error;
};

/// Runs a program through a shell with these arguments; `before` is put in front of it (ulimit …;).
ProgramResult run_program(const std::string& program, const std::string& arguments, const std::string& before = "");

std::string read_file(const std::filesystem::path& file);

/// A folder that is removed with everything in it at the end.
class ScratchFolder {
 public:
  ScratchFolder();
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  ~ScratchFolder();
  std::filesystem::path path() const { return path_; }
  std::string operator/(const std::string& name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

}  // namespace test
