#pragma once

#include <stdexcept>
#include <string>

namespace base {

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

/// A file could not be read or written (missing, not permitted, a folder).
class FileError : public InputError {
 public:
  using InputError::InputError;
};

/// The disk could not take what was written: it is full, a quota or a limit of file sizes is used up, or it failed.
/// Nothing that was given is wrong.
class DiskError : public FileError {
 public:
  using FileError::FileError;
};

}  // namespace base
