#pragma once

#include <cstdint>
#include <cstring>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

namespace foamsim::web::test {

/// A packed frame, read as the viewer reads it.
class UnpackedFrame {
 public:
  explicit UnpackedFrame(const std::string& bytes) : bytes_(bytes) {
    std::uint32_t length = 0;
    std::memcpy(&length, bytes.data() + 4, sizeof(length));
    head = nlohmann::json::parse(bytes.substr(8, length));
    first_ = 8 + length;
  }

  nlohmann::json head;

  /// The numbers of an array, as they were before they were packed; empty where there is none.
  template <class Number>
  std::vector<Number> array(const std::string& name) const {
    std::size_t at = first_;
    for (const nlohmann::json& entry : head["arrays"]) {
      const std::size_t components = entry["components"], count = entry["count"].get<std::size_t>() * components;
      const std::string type = entry["type"];
      const std::size_t size = type == "u8" ? 1 : type == "u16" ? 2 : 4;
      if (entry["name"] == name && size == sizeof(Number))
        return numbers<Number>(at, count, entry["differences"].get<bool>() ? components : 0);
      at += count * size;
    }
    return {};
  }

  std::size_t size_by_head() const {
    std::size_t at = first_;
    for (const nlohmann::json& entry : head["arrays"]) {
      const std::string type = entry["type"];
      at += entry["count"].get<std::size_t>() * entry["components"].get<std::size_t>() *
            (type == "u8"    ? 1U
             : type == "u16" ? 2U
                             : 4U);
    }
    return at;
  }

 private:
  template <class Number>
  std::vector<Number> numbers(std::size_t at, std::size_t count, std::size_t distance) const {
    std::vector<Number> result(count);
    for (std::size_t i = 0; i < count; ++i) {
      char parts[sizeof(Number)];
      for (std::size_t k = 0; k < sizeof(Number); ++k) parts[k] = bytes_[at + k * count + i];
      std::memcpy(&result[i], parts, sizeof(Number));
      if (distance > 0 && i >= distance) result[i] = static_cast<Number>(result[i] + result[i - distance]);
    }
    return result;
  }

  std::string bytes_;
  std::size_t first_ = 0;
};

}  // namespace foamsim::web::test
