#include "LosTopos/io/fe_numbers.h"

#include <algorithm>
#include <limits>

namespace lostopos {

void FeNumbers::add(std::uint32_t number, std::size_t line) {
  entries_.push_back({number, static_cast<std::uint32_t>(entries_.size()), line});
}

std::optional<FeNumbers::Entry> FeNumbers::sort() {
  if (!std::ranges::is_sorted(entries_, {}, &Entry::number)) std::ranges::stable_sort(entries_, {}, &Entry::number);
  const auto twice = std::ranges::adjacent_find(entries_, {}, &Entry::number);
  if (twice == entries_.end()) return std::nullopt;
  return *std::next(twice);
}

std::optional<std::uint32_t> FeNumbers::find(std::int64_t number) const {
  if (number == std::numeric_limits<std::int64_t>::min()) return std::nullopt;
  const std::int64_t positive = number < 0 ? -number : number;
  const auto found = std::ranges::lower_bound(entries_, positive, {}, &Entry::number);
  if (found == entries_.end() || found->number != positive) return std::nullopt;
  return found->index;
}

}  // namespace lostopos
