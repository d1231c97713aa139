#include "Base/process/child_process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <thread>
#include <utility>

#include "Base/error.h"

namespace base {
namespace {

// What posix_spawn is told besides the arguments.
class SpawnSettings {
 public:
  explicit SpawnSettings(const ProcessStart& start) {
    posix_spawn_file_actions_init(&actions_);
    posix_spawnattr_init(&attributes_);
    posix_spawn_file_actions_addopen(&actions_, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions_, STDOUT_FILENO, start.output.c_str(), O_WRONLY | O_CREAT | O_APPEND,
                                     0666);
    posix_spawn_file_actions_adddup2(&actions_, STDOUT_FILENO, STDERR_FILENO);
    // A descriptor that is copied onto itself stays open in the new program.
    if (start.keep_open) posix_spawn_file_actions_adddup2(&actions_, *start.keep_open, *start.keep_open);
    if (start.own_group) {
      posix_spawnattr_setflags(&attributes_, POSIX_SPAWN_SETPGROUP);
      posix_spawnattr_setpgroup(&attributes_, 0);
    }
  }
  SpawnSettings(const SpawnSettings&) = delete;
  SpawnSettings& operator=(const SpawnSettings&) = delete;
  ~SpawnSettings() {
    posix_spawnattr_destroy(&attributes_);
    posix_spawn_file_actions_destroy(&actions_);
  }
  const posix_spawn_file_actions_t* actions() const { return &actions_; }
  const posix_spawnattr_t* attributes() const { return &attributes_; }

 private:
  posix_spawn_file_actions_t actions_;
  posix_spawnattr_t attributes_;
};

ProcessEnd end_of(int status) {
  if (WIFSIGNALED(status)) return {128 + WTERMSIG(status), WTERMSIG(status)};
  return {WEXITSTATUS(status), 0};
}

// A file of its own for what a command says, removed at the end.
class OutputFile {
 public:
  OutputFile() : path_((std::filesystem::temp_directory_path() / "command-XXXXXX").string()) {
    const int descriptor = mkstemp(path_.data());
    if (descriptor < 0) throw FileError("cannot make the file " + path_ + ": " + std::strerror(errno));
    close(descriptor);
  }
  OutputFile(const OutputFile&) = delete;
  OutputFile& operator=(const OutputFile&) = delete;
  ~OutputFile() { std::remove(path_.c_str()); }
  const std::string& path() const { return path_; }
  std::string text() const {
    std::ifstream in(path_, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

 private:
  std::string path_;
};

}  // namespace

ChildProcess::ChildProcess(const ProcessStart& start) {
  const SpawnSettings settings(start);
  std::vector<char*> words{const_cast<char*>(start.program.c_str())};
  for (const std::string& argument : start.arguments) words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  const int error =
      posix_spawnp(&id_, start.program.c_str(), settings.actions(), settings.attributes(), words.data(), environ);
  if (error == 0) return;
  id_ = 0;
  throw FileError("cannot run " + start.program.string() + ": " + std::strerror(error));
}

ChildProcess::ChildProcess(ChildProcess&& other) noexcept : id_(std::exchange(other.id_, 0)), end_(other.end_) {}

ChildProcess::~ChildProcess() {
  if (id_ == 0) return;
  kill(id_, SIGTERM);
  int status = 0;
  while (waitpid(id_, &status, 0) < 0 && errno == EINTR) {
  }
}

std::optional<ProcessEnd> ChildProcess::end() {
  if (end_ || id_ == 0) return end_;
  int status = 0;
  const pid_t waited = waitpid(id_, &status, WNOHANG);
  if (waited == id_) end_ = end_of(status);
  // Somebody else waited for it: it has ended, and nobody can say how.
  if (waited < 0 && errno == ECHILD) end_ = ProcessEnd{127, 0};
  if (end_) id_ = 0;
  return end_;
}

void ChildProcess::signal(int number) const {
  if (id_ != 0) kill(id_, number);
}

std::string signal_text(int signal) {
  const char* name = sigdescr_np(signal);
  return "ended by signal " + std::to_string(signal) + (name != nullptr ? " (" + std::string(name) + ")" : "");
}

CommandResult run_command(const std::string& program, const std::vector<std::string>& arguments, double seconds) {
  constexpr auto interval = std::chrono::milliseconds(10);
  const OutputFile output;
  ChildProcess process({.program = program, .arguments = arguments, .output = output.path()});
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (std::chrono::steady_clock::now() < until) {
    if (const auto end = process.end()) return {end->exit_code, output.text()};
    std::this_thread::sleep_for(interval);
  }
  process.signal(SIGKILL);
  throw Error(program + " did not answer within " + std::to_string(static_cast<long>(seconds)) + " s");
}

}  // namespace base
