#include "FoamSim/web/gzip.h"

#include <zlib.h>

#include <algorithm>
#include <array>
#include <limits>

#include "Base/error.h"

namespace foamsim::web {
namespace {

constexpr int gzip_window = 15 + 16;  // the largest window; 16 asks for gzip's head

void require(bool right) {
  if (!right) throw base::Error("cannot compress: memory has run out");
}

}  // namespace

std::string gzip(std::string_view bytes) {
  z_stream stream{};
  require(deflateInit2(&stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, gzip_window, 8, Z_DEFAULT_STRATEGY) == Z_OK);
  std::string result;
  std::array<Bytef, 1 << 16> piece;
  int state = Z_OK;
  while (state == Z_OK) {
    if (stream.avail_in == 0 && !bytes.empty()) {
      const std::size_t length = std::min<std::size_t>(bytes.size(), std::numeric_limits<uInt>::max() / 2);
      stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
      stream.avail_in = static_cast<uInt>(length);
      bytes.remove_prefix(length);
    }
    stream.next_out = piece.data();
    stream.avail_out = static_cast<uInt>(piece.size());
    state = deflate(&stream, bytes.empty() ? Z_FINISH : Z_NO_FLUSH);
    result.append(reinterpret_cast<const char*>(piece.data()), piece.size() - stream.avail_out);
  }
  deflateEnd(&stream);
  require(state == Z_STREAM_END);
  return result;
}

}  // namespace foamsim::web
