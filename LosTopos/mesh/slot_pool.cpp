#include "LosTopos/mesh/slot_pool.h"

namespace lostopos {

std::uint32_t SlotPool::take() {
  if (free_.empty()) {
    alive_.push_back(1);
    return static_cast<std::uint32_t>(alive_.size() - 1);
  }
  const std::uint32_t slot = free_.back();
  free_.pop_back();
  alive_[slot] = 1;
  return slot;
}

void SlotPool::give_back(std::uint32_t slot) {
  alive_[slot] = 0;
  free_.push_back(slot);
}

std::vector<std::uint32_t> SlotPool::compact() {
  std::vector<std::uint32_t> kept;
  kept.reserve(living());
  for (std::uint32_t slot = 0; slot < alive_.size(); ++slot)
    if (alive_[slot]) kept.push_back(slot);
  alive_.assign(kept.size(), 1);
  alive_.shrink_to_fit();
  free_.clear();
  free_.shrink_to_fit();
  return kept;
}

}  // namespace lostopos
