#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace base {

/// How a process ended: with an exit code, or by a signal.
struct ProcessEnd {
  int exit_code = 0;  ///< as a shell has it: 128 + signal where a signal ended it
  int signal = 0;     ///< 0: none
};

/// How a process is started.
struct ProcessStart {
  std::filesystem::path program;  ///< a path, or a name that is looked up in PATH
  std::vector<std::string> arguments;
  std::filesystem::path output;       ///< both streams are appended to this file
  bool own_group = false;             ///< out of reach of the terminal's Ctrl-C, which ends the group of its caller
  std::optional<int> keep_open = {};  ///< a file descriptor that it inherits
};

/// A process that was started and is asked now and then whether it has ended. The destructor asks it to end (SIGTERM)
/// and waits for that, so that none is left behind.
class ChildProcess {
 public:
  /// Starts it with an empty standard input. Throws FileError where there is no such program or the output cannot be
  /// written.
  explicit ChildProcess(const ProcessStart& start);
  ChildProcess(ChildProcess&& other) noexcept;
  ChildProcess& operator=(ChildProcess&&) = delete;
  ~ChildProcess();

  /// How it ended, or nothing while it goes on. Does not wait.
  std::optional<ProcessEnd> end();
  /// Sends it a signal while it goes on.
  void signal(int number) const;

 private:
  int id_ = 0;  // 0: it was waited for, or moved from
  std::optional<ProcessEnd> end_;
};

/// "ended by signal 11 (Segmentation fault)".
std::string signal_text(int signal);

/// What a short command said.
struct CommandResult {
  int exit_code = 0;
  std::string output;  ///< of both streams
};

/// Runs a command to its end, for at most `seconds`. Throws FileError where there is no such program, and Error when it
/// takes longer; it is ended then.
CommandResult run_command(const std::string& program, const std::vector<std::string>& arguments, double seconds);

}  // namespace base
