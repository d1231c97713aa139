#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace lostopos {

/// `bytes` in the base64 alphabet of RFC 4648, padded.
std::string base64_encode(std::string_view bytes);

/// The bytes that `text` stands for; white space is passed over, and padding may stand between pieces that were encoded
/// one by one. Nothing when there is another character, or the text ends within a group of four.
std::optional<std::string> base64_decode(std::string_view text);

}  // namespace lostopos
