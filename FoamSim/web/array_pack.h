#pragma once

#include <array>
#include <cstddef>
#include <cstring>
#include <span>
#include <string>
#include <vector>

namespace foamsim::web {

/// Appends numbers byte plane by byte plane, the lowest bytes of all of them first.
template <class Number>
void append_planes(std::string& out, std::span<const Number> numbers) {
  const std::size_t begin = out.size();
  out.resize(begin + numbers.size() * sizeof(Number));
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    std::array<char, sizeof(Number)> bytes;
    std::memcpy(bytes.data(), &numbers[i], sizeof(Number));
    for (std::size_t k = 0; k < sizeof(Number); ++k) out[begin + k * numbers.size() + i] = bytes[k];
  }
}

/// The differences of each number to that `components` before, modulo what the type holds.
template <class Number>
std::vector<Number> differences(std::span<const Number> numbers, std::size_t components) {
  std::vector<Number> result(numbers.begin(), numbers.end());
  for (std::size_t i = result.size(); i-- > components;)
    result[i] = static_cast<Number>(result[i] - result[i - components]);
  return result;
}

}  // namespace foamsim::web
