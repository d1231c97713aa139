#pragma once

#include <cstdint>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

namespace base {

/// Bytes as a JSON value. What nlohmann's json::binary does, but for this: where that runs out of memory it destroys
/// what it has not made (3.11 sets the kind of a value before the value).
inline nlohmann::json binary_json(std::vector<std::uint8_t> bytes) {
  nlohmann::json value = nlohmann::json::binary_t();
  std::vector<std::uint8_t>& held = value.get_binary();
  held = std::move(bytes);
  return value;
}

}  // namespace base
