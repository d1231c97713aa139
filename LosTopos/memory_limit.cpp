#include "LosTopos/memory_limit.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "Base/error.h"
#include "Base/machine/memory.h"

namespace lostopos {
namespace {

constexpr const char* key = "memory_limit";
constexpr double bytes_of_gigabyte = 1e9;

}  // namespace

base::OptionSpec memory_limit_spec() {
  auto spec = base::positive_number(key, 0, "memory that a run may take, GB; auto: 80% of what the machine has left");
  spec.named_numbers = {{"auto", 0}};
  return spec;
}

double memory_limit(const base::OptionSet& options) {
  constexpr double share_of_free = 0.8;
  if (const double given = options.number(key); given > 0) return bytes_of_gigabyte * given;
  const auto available = base::available_memory();
  return available ? share_of_free * *available : std::numeric_limits<double>::infinity();
}

double triangles_on(double area, double edge) {
  return area / (std::numbers::sqrt3 / 4 * edge * edge);
}

std::size_t triangles_within(double limit, double bytes_each) {
  const double most = std::max(1.0, (limit - bytes_of_program) / bytes_each);
  constexpr auto none = std::numeric_limits<std::size_t>::max();
  return most < static_cast<double>(none) ? static_cast<std::size_t>(most) : none;
}

void require_memory(const SizeEstimate& size, double limit) {
  if (size.bytes <= limit) return;
  throw base::InputError("this would be about " + base::to_text(std::round(size.triangles)) +
                         " triangles, which take " + base::bytes_in_words(size.bytes) + ", more than the limit of " +
                         base::bytes_in_words(limit) +
                         "; a smaller surface or a coarser resolution would fit, and memory_limit (GB; auto: 80% of "
                         "what is left) says what may be taken");
}

}  // namespace lostopos
