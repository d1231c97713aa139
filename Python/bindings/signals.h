#pragma once

#include <atomic>
#include <chrono>
#include <exception>
#include <functional>
#include <thread>

namespace foamsim::python {

/// Lets long work hear of Ctrl-C: it runs without the interpreter's lock, and every few hundredths of a second its
/// thread takes the lock and runs Python's signal handlers.
class SignalWatch {
 public:
  /// Does the work without the lock. Throws what it throws; where a signal's handler has raised an exception and the
  /// work has stopped for it, that exception.
  void run(const std::function<void()>& work);
  /// For base::Interruption: whether a handler has raised an exception.
  bool asked();

 private:
  std::thread::id thread_;
  std::chrono::steady_clock::time_point last_;
  std::atomic<bool> stop_ = false;
  std::exception_ptr raised_;
};

}  // namespace foamsim::python
