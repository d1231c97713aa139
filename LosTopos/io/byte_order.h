#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <string>
#include <type_traits>

namespace lostopos {

/// The number stored in the sizeof(T) bytes at `bytes` in the given order, whatever the machine's own.
template <class T>
T number_from_bytes(const char* bytes, std::endian order) {
  static_assert(std::is_arithmetic_v<T>);
  std::array<char, sizeof(T)> raw;
  std::memcpy(raw.data(), bytes, sizeof(T));
  if (order != std::endian::native) std::ranges::reverse(raw);
  return std::bit_cast<T>(raw);
}

/// Appends the bytes of `value`, little end first.
template <class T>
void append_bytes(std::string& bytes, T value) {
  static_assert(std::is_arithmetic_v<T>);
  auto raw = std::bit_cast<std::array<char, sizeof(T)>>(value);
  if (std::endian::native != std::endian::little) std::ranges::reverse(raw);
  bytes.append(raw.data(), raw.size());
}

}  // namespace lostopos
