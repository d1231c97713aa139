#include "FoamSim/render/image.h"

#include <string>

#include "Base/error.h"

namespace foamsim::render {

Image::Image(int width, int height, Pixel fill) : width_(width), height_(height) {
  constexpr int kMaxSize = 65535;
  if (width < 1 || height < 1 || width > kMaxSize || height > kMaxSize) {
    throw base::InputError("picture size " + std::to_string(width) + " x " + std::to_string(height) +
                           ": both must be in 1 ... 65535");
  }
  pixels_.assign(static_cast<std::size_t>(width) * height, fill);
}

}  // namespace foamsim::render
