#include "Python/bindings/signals.h"

#include <pybind11/pybind11.h>

#include <utility>

#include "Base/interruption.h"

namespace foamsim::python {

namespace py = pybind11;

void SignalWatch::run(const std::function<void()>& work) {
  thread_ = std::this_thread::get_id();
  last_ = std::chrono::steady_clock::now();
  stop_ = false;
  try {
    const py::gil_scoped_release unlocked;
    work();
  } catch (const base::Interrupted&) {
    if (raised_ == nullptr) throw;
  }
  if (raised_ != nullptr) std::rethrow_exception(std::exchange(raised_, nullptr));
}

bool SignalWatch::asked() {
  constexpr std::chrono::milliseconds interval(30);
  if (stop_) return true;
  if (std::this_thread::get_id() != thread_) return false;
  const auto now = std::chrono::steady_clock::now();
  if (now - last_ < interval) return false;
  last_ = now;
  const py::gil_scoped_acquire lock;
  if (PyErr_CheckSignals() == 0) return false;
  raised_ = std::make_exception_ptr(py::error_already_set());
  stop_ = true;
  return true;
}

}  // namespace foamsim::python
