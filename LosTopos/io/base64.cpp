#include "LosTopos/io/base64.h"

#include <array>
#include <cstdint>

namespace lostopos {
namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<std::int16_t, 256> make_values() {
  std::array<std::int16_t, 256> values{};
  values.fill(-1);
  for (std::size_t i = 0; i < alphabet.size(); ++i)
    values[static_cast<unsigned char>(alphabet[i])] = static_cast<std::int16_t>(i);
  return values;
}
constexpr std::array<std::int16_t, 256> values = make_values();

bool is_space(char c) {
  return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}

}  // namespace

std::string base64_encode(std::string_view bytes) {
  std::string text;
  text.reserve((bytes.size() + 2) / 3 * 4);
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::string_view piece = bytes.substr(i, 3);
    std::uint32_t bits = 0;
    for (std::size_t k = 0; k < 3; ++k)
      bits = (bits << 8U) | (k < piece.size() ? static_cast<unsigned char>(piece[k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) text += k <= piece.size() ? alphabet[(bits >> (18U - 6U * k)) & 63U] : '=';
  }
  return text;
}

std::optional<std::string> base64_decode(std::string_view text) {
  std::string bytes;
  bytes.reserve(text.size() / 4 * 3);
  std::uint32_t bits = 0;
  unsigned digits = 0, padding = 0;  // of the present group
  for (const char c : text) {
    if (is_space(c)) continue;
    const int value = values[static_cast<unsigned char>(c)];
    if (c == '=' && digits >= 2) {
      ++padding;
    } else if (value < 0 || padding > 0) {
      return std::nullopt;
    }
    bits = (bits << 6U) | static_cast<std::uint32_t>(c == '=' ? 0 : value);
    if (++digits < 4) continue;
    for (unsigned k = 0; k < 3 - padding; ++k) bytes += static_cast<char>((bits >> (16U - 8U * k)) & 255U);
    bits = digits = padding = 0;
  }
  if (digits != 0) return std::nullopt;
  return bytes;
}

}  // namespace lostopos
