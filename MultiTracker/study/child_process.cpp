#include "MultiTracker/study/child_process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>

#include "Base/error.h"
#include "Base/timing/stopwatch.h"

namespace multitracker {
namespace {

constexpr int poll_milliseconds = 100;

void write_all(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(file, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    done += static_cast<std::size_t>(count);
  }
}

[[noreturn]] void be_child(const std::function<std::string()>& work, int out) {
  // The parent decides what Ctrl-C means.
  std::signal(SIGINT, SIG_IGN);
  int code = 0;
  try {
    write_all(out, work());
  } catch (const std::exception& error) {
    write_all(out, error.what());
    code = 1;
  }
  ::close(out);
  ::_exit(code);
}

// Reads until the child closes its end; false when the time is up or somebody interrupts.
bool read_all(int file, double time_limit, const std::function<bool()>& interrupted, std::string& text) {
  const base::Stopwatch watch;
  std::array<char, 4096> buffer;
  while (true) {
    pollfd wanted{file, POLLIN, 0};
    const int ready = ::poll(&wanted, 1, poll_milliseconds);
    if (ready > 0) {
      const ssize_t count = ::read(file, buffer.data(), buffer.size());
      if (count == 0) return true;
      if (count > 0) text.append(buffer.data(), static_cast<std::size_t>(count));
    }
    if (watch.seconds() > time_limit) return false;
    if (interrupted && interrupted()) return false;
  }
}

double seconds(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ChildResult run_in_child(const std::function<std::string()>& work, double time_limit,
                         const std::function<bool()>& interrupted) {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0)
    throw base::FileError(std::string("cannot make a pipe to a child process: ") + std::strerror(errno));
  const pid_t child = ::fork();
  if (child < 0) throw base::FileError(std::string("cannot start a child process: ") + std::strerror(errno));
  if (child == 0) {
    ::close(ends[0]);
    be_child(work, ends[1]);
  }
  ::close(ends[1]);
  ChildResult result;
  const bool in_time = read_all(ends[0], time_limit, interrupted, result.text);
  ::close(ends[0]);
  if (!in_time) ::kill(child, SIGKILL);
  int status = 0;
  rusage usage{};
  while (::wait4(child, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  result.cpu_seconds = seconds(usage.ru_utime) + seconds(usage.ru_stime);
  result.peak_megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  result.finished = in_time && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!in_time)
    result.text = "took more than " + std::to_string(static_cast<long>(time_limit)) + " s";
  else if (WIFSIGNALED(status))
    result.text = std::string("ended by signal: ") + strsignal(WTERMSIG(status));
  return result;
}

}  // namespace multitracker
