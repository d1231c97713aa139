#pragma once

#include <filesystem>

#include "FoamSim/render/image.h"

namespace foamsim::render {

/// Writes a PNG: 8-bit sRGB, with an alpha channel only if some pixel is not opaque.
///
/// Atomic: the file is written under a temporary name beside `path` and renamed when complete, so `path` holds either
/// what it held before or the whole picture. (If `path` is a device or a pipe, it is written to directly.)
/// @throws base::InputError  if the picture is empty.
/// @throws base::FileError   if it cannot be written (no such folder, no permission, disk full); nothing is left.
void write_png(const Image& image, const std::filesystem::path& path);

}  // namespace foamsim::render
