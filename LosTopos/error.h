#pragma once

#include <stdexcept>
#include <string>

namespace lostopos {

/// Base of every exception thrown by the project. The message says what was wrong, where, and what would be right.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// The caller or the user gave something that cannot be used: a bad option, an unknown name, a malformed file.
class InputError : public Error {
 public:
  using Error::Error;
};

/// A file could not be read or written (missing, not permitted, disk full).
class FileError : public InputError {
 public:
  using InputError::InputError;
};

/// A mesh operation was asked of elements that do not allow it (dead handle, degenerate triangle, equal labels).
class MeshError : public Error {
 public:
  using Error::Error;
};

/// The surface cannot be moved to where it is asked to go; it has been left where it was.
class MotionError : public Error {
 public:
  using Error::Error;
};

}  // namespace lostopos
