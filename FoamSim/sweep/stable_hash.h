#pragma once

#include <cstdint>
#include <cstdio>
#include <string>
#include <string_view>

namespace foamsim::sweep {

/// 16 hexadecimal digits that tell texts apart, the same on every machine (FNV-1a of 64 bits).
inline std::string stable_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  char digits[17];
  std::snprintf(digits, sizeof(digits), "%016llx", static_cast<unsigned long long>(hash));
  return digits;
}

}  // namespace foamsim::sweep
