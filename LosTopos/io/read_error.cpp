#include "LosTopos/io/read_error.h"

#include "Base/error.h"

namespace lostopos {

void throw_at_line(const std::string& file, std::size_t line, const std::string& problem) {
  throw base::InputError(file + ", line " + std::to_string(line) + ": " + problem);
}

void throw_at_byte(const std::string& file, std::uint64_t offset, const std::string& problem) {
  throw base::InputError(file + ", byte " + std::to_string(offset) + ": " + problem);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 40;
  constexpr std::string_view digits = "0123456789abcdef";
  std::string result = "'";
  for (const char c : text.substr(0, longest)) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte >= 0x20 && byte < 0x7f) {
      result += c;
    } else {
      result += "\\x";
      result += digits[byte >> 4U];
      result += digits[byte & 15U];
    }
  }
  return result + (text.size() > longest ? "…'" : "'");
}

}  // namespace lostopos
