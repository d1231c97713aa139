#pragma once

#include <filesystem>

namespace base {

/// Waits until a file's content, or a folder's list of names, has reached the disk (fsync), so that a power cut leaves
/// it as it is now. Does nothing where there is no such file, or no disk behind it. Throws DiskError when the disk
/// fails.
void wait_for_disk(const std::filesystem::path& path);
/// The same of an open file; `path` is for the message.
void wait_for_disk(int descriptor, const std::filesystem::path& path);

}  // namespace base
