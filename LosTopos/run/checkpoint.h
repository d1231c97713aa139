#pragma once

#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <span>
#include <string>
#include <vector>

namespace lostopos::run {

/// Whose checkpoint it is, and in which version of its content: what does not fit is refused when it is read.
struct CheckpointFormat {
  std::string program;  ///< "foamsim", say
  int version = 1;
};

/// What takes the content of a checkpoint.
using TakeCheckpoint = std::function<void(const nlohmann::json& content)>;

/// The bytes of a checkpoint's file: `content`, an object, with its format as CBOR, behind a head with a checksum (see
/// sealed_bytes.h).
std::vector<std::uint8_t> checkpoint_bytes(const CheckpointFormat& format, nlohmann::json content);
/// Writes them to `file`, atomically; they are on the disk then. Throws base::FileError, base::DiskError.
void write_checkpoint(const std::filesystem::path& file, const CheckpointFormat& format, nlohmann::json content);

/// Hands the content of a checkpoint to `take`, which builds from it all that can only be built from content that is
/// sound. Throws base::InputError, one line that begins with `name`, when `bytes` are not a whole checkpoint of this
/// format, and for every exception that `take` throws but std::bad_alloc and base::Interrupted.
void take_checkpoint(std::span<const std::uint8_t> bytes, const std::string& name, const CheckpointFormat& format,
                     const TakeCheckpoint& take);
/// The same of a file. Throws base::FileError when it cannot be read.
void read_checkpoint(const std::filesystem::path& file, const CheckpointFormat& format, const TakeCheckpoint& take);

}  // namespace lostopos::run
