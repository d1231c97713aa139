#pragma once

#include <pybind11/pybind11.h>

#include <memory>
#include <utility>

namespace foamsim::python {

/// A Python object that C++ may copy and drop on any thread, with or without the interpreter's lock.
using HeldObject = std::shared_ptr<const pybind11::object>;

/// To be called with the lock.
inline HeldObject hold(pybind11::object object) {
  return {new pybind11::object(std::move(object)), [](const pybind11::object* held) {
            const pybind11::gil_scoped_acquire lock;
            delete held;
          }};
}

}  // namespace foamsim::python
