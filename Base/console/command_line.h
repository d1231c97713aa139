#pragma once

#include <string>

#include "Base/console/command.h"

namespace base {

/// Reads a program's command line by what its commands say they take.
class CommandLine {
 public:
  CommandLine(std::string name, std::string summary, std::string version)
      : root_(std::move(name), std::move(summary)), version_(std::move(version)) {}
  CommandLine(const CommandLine&) = delete;
  CommandLine& operator=(const CommandLine&) = delete;

  Command& root() { return root_; }
  const Command& root() const { return root_; }
  const std::string& name() const { return root_.name(); }
  const std::string& version() const { return version_; }

  /// Reads the words into the targets of the command that they name, does its action, and returns the exit code; prints
  /// help or the version when that is asked for. Throws InputError with what would be right.
  int run(int argc, const char* const* argv) const;

 private:
  Command root_;
  std::string version_;
};

}  // namespace base
