#pragma once

#include <string>
#include <string_view>

namespace foamsim::web {

/// The bytes in gzip's form (RFC 1952). Throws base::Error where memory runs out.
std::string gzip(std::string_view bytes);

}  // namespace foamsim::web
