#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>

#include "Base/timing/stopwatch.h"

namespace multitracker {

/// How a child process ended.
struct ChildResult {
  bool finished = false;  ///< it returned its text; false: crashed, or used up its time
  std::string text;       ///< what it returned, or how it ended
  bool late = false;      ///< it used up its time
  double cpu_seconds = 0;
  double peak_megabytes = 0;  ///< of memory in use
};

/// Work for a child process, which returns a text. It asks `stop` now and then whether it has been told to end, or its
/// parent is gone.
using ChildWork = std::function<std::string(const std::function<bool()>& stop)>;

/// Work in a process of its own, so that a crash, the memory and the time are its alone. The destructor ends it.
class ForkedChild {
 public:
  /// A child that takes more than `time_limit` seconds (wall) is ended. The calling process must not have started
  /// threads. Throws base::FileError when the system has no room for another process.
  ForkedChild(const ChildWork& work, double time_limit);
  ForkedChild(ForkedChild&& other) noexcept;
  ForkedChild& operator=(ForkedChild&&) = delete;
  ~ForkedChild();

  /// How it ended, or nothing while it goes on. Waits for at most `seconds`; to be asked often, for it also empties
  /// what the child writes. Once.
  std::optional<ChildResult> result(double seconds);
  /// Tells it to end by itself; one that has not done so half a minute later is ended.
  void ask_to_stop();

 private:
  bool take_text(double seconds);
  ChildResult wait(bool in_time);

  int id_ = 0;  // 0: it was waited for, or moved from
  int text_end_ = -1;
  // Both ends stay open here: writing to a child that has just ended is no error then.
  std::array<int, 2> stop_ends_{-1, -1};
  std::string text_;
  double time_limit_;
  base::Stopwatch watch_;
};

}  // namespace multitracker
