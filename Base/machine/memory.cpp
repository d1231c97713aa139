#include "Base/machine/memory.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <sstream>

namespace base {

// Linux tells it in kB, memory that caches would give back included.
std::optional<double> available_memory() {
  std::ifstream info("/proc/meminfo");
  std::string line;
  while (std::getline(info, line)) {
    std::istringstream words(line);
    std::string name;
    double kilobytes = 0;
    if (words >> name >> kilobytes && name == "MemAvailable:") return 1024 * kilobytes;
  }
  return std::nullopt;
}

void give_back_large_blocks() {
#ifdef __GLIBC__
  constexpr int large = 1 << 20;
  ::mallopt(M_MMAP_THRESHOLD, large);  // as a constant: glibc raises it up to 32 MB with what is freed
#endif
}

std::string bytes_in_words(double bytes) {
  constexpr std::array units{"bytes", "kB", "MB", "GB", "TB", "PB"};
  std::size_t unit = 0;
  for (; bytes >= 999.5 && unit + 1 < units.size(); ++unit) bytes /= 1000;
  const double digit = std::pow(10.0, std::floor(std::log10(std::max(bytes, 1.0))) - 1);
  std::ostringstream text;
  text << std::round(bytes / digit) * digit << ' ' << units[unit];
  return text.str();
}

}  // namespace base
