#include "MultiTracker/study/child_process.h"

#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <utility>

#include "Base/error.h"

namespace multitracker {
namespace {

constexpr double seconds_to_stop = 30;
// Looking whether to stop costs a call of the system: work that asks all the time gets an answer this old.
constexpr double seconds_between_looks = 0.02;

void write_all(int file, const std::string& text) {
  std::size_t done = 0;
  while (done < text.size()) {
    const ssize_t count = ::write(file, text.data() + done, text.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return;
    done += static_cast<std::size_t>(count);
  }
}

bool has_something(int file, int milliseconds) {
  pollfd wanted{file, POLLIN, 0};
  return ::poll(&wanted, 1, milliseconds) > 0;
}

[[noreturn]] void be_child(const ChildWork& work, pid_t parent, int text_end, int stop_end) {
  // The parent decides what Ctrl-C means.
  std::signal(SIGINT, SIG_IGN);
  base::Stopwatch since_look;
  bool stopping = has_something(stop_end, 0);
  const auto stop = [&] {
    if (stopping || since_look.seconds() < seconds_between_looks) return stopping;
    since_look.restart();
    stopping = ::getppid() != parent || has_something(stop_end, 0);
    return stopping;
  };
  int code = 0;
  try {
    write_all(text_end, work(stop));
  } catch (const std::exception& error) {
    write_all(text_end, error.what());
    code = 1;
  }
  ::close(text_end);
  ::_exit(code);
}

std::array<int, 2> pipe_to_child() {
  std::array<int, 2> ends{};
  if (::pipe(ends.data()) != 0)
    throw base::FileError(std::string("cannot make a pipe to a child process: ") + std::strerror(errno));
  return ends;
}

void close_both(const std::array<int, 2>& ends) {
  for (int end : ends) ::close(end);
}

double seconds_in(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

}  // namespace

ForkedChild::ForkedChild(const ChildWork& work, double time_limit) : time_limit_(time_limit) {
  const std::array<int, 2> text = pipe_to_child();
  std::array<int, 2> stop{};
  try {
    stop = pipe_to_child();
  } catch (...) {
    close_both(text);
    throw;
  }
  const pid_t parent = ::getpid();
  id_ = ::fork();
  if (id_ < 0) {
    const std::string why = std::strerror(errno);
    close_both(text);
    close_both(stop);
    throw base::FileError("cannot start a child process: " + why);
  }
  if (id_ == 0) {
    ::close(text[0]);
    be_child(work, parent, text[1], stop[0]);
  }
  ::close(text[1]);
  text_end_ = text[0];
  stop_ends_ = stop;
}

ForkedChild::ForkedChild(ForkedChild&& other) noexcept
    : id_(std::exchange(other.id_, 0)),
      text_end_(std::exchange(other.text_end_, -1)),
      stop_ends_(other.stop_ends_),
      text_(std::move(other.text_)),
      time_limit_(other.time_limit_),
      watch_(other.watch_) {}

ForkedChild::~ForkedChild() {
  if (id_ != 0) wait(false);
}

void ForkedChild::ask_to_stop() {
  write_all(stop_ends_[1], "s");
  time_limit_ = std::min(time_limit_, watch_.seconds() + seconds_to_stop);
}

// False: it goes on. It has ended, or is about to, when it closes its end.
bool ForkedChild::take_text(double seconds) {
  std::array<char, 4096> buffer;
  int milliseconds = static_cast<int>(1000 * seconds);
  while (has_something(text_end_, milliseconds)) {
    const ssize_t count = ::read(text_end_, buffer.data(), buffer.size());
    if (count == 0 || (count < 0 && errno != EINTR)) return true;
    if (count > 0) text_.append(buffer.data(), static_cast<std::size_t>(count));
    milliseconds = 0;
  }
  return false;
}

std::optional<ChildResult> ForkedChild::result(double seconds) {
  if (take_text(seconds)) return wait(true);
  if (watch_.seconds() > time_limit_) return wait(false);
  return {};
}

ChildResult ForkedChild::wait(bool in_time) {
  if (!in_time) ::kill(id_, SIGKILL);
  ChildResult result;
  int status = 0;
  rusage usage{};
  while (::wait4(id_, &status, 0, &usage) < 0 && errno == EINTR) {
  }
  id_ = 0;
  ::close(text_end_);
  close_both(stop_ends_);
  result.text = std::move(text_);
  result.late = !in_time;
  result.cpu_seconds = seconds_in(usage.ru_utime) + seconds_in(usage.ru_stime);
  result.peak_megabytes = static_cast<double>(usage.ru_maxrss) / 1024;
  result.finished = in_time && WIFEXITED(status) && WEXITSTATUS(status) == 0;
  if (!in_time)
    result.text = "took more than " + std::to_string(static_cast<long>(time_limit_)) + " s";
  else if (WIFSIGNALED(status))
    result.text = std::string("ended by signal: ") + strsignal(WTERMSIG(status));
  return result;
}

}  // namespace multitracker
