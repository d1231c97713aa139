#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace lostopos::run {

/// Whose checkpoint it is, and in which version of its content: what does not fit is refused when it is read.
struct CheckpointFormat {
  std::string program;  ///< "foamsim", say
  int version = 1;
};

/// Writes `content` with its format to `file` (CBOR), atomically; it is on the disk then. Throws
/// base::FileError, base::DiskError.
void write_checkpoint(const std::filesystem::path& file, const CheckpointFormat& format, const nlohmann::json& content);

/// The content of a checkpoint, handed to `take`. Throws base::FileError when the file cannot be read, and
/// base::InputError, naming the file, when it is not a whole checkpoint of this format or `take` throws a base::Error
/// or a JSON exception.
void read_checkpoint(const std::filesystem::path& file, const CheckpointFormat& format,
                     const std::function<void(const nlohmann::json& content)>& take);

}  // namespace lostopos::run
