#pragma once

#include <cstdint>
#include <vector>

namespace lostopos {

/// Which slots of an element array are in use, and which free one to take next (the last one freed).
class SlotPool {
 public:
  SlotPool() = default;
  /// From stored flags and the free slots in the order they were freed.
  SlotPool(std::vector<char> alive, std::vector<std::uint32_t> free)
      : alive_(std::move(alive)), free_(std::move(free)) {}

  /// Takes a free slot, or a new one at the end: then `slots()` has grown by one.
  std::uint32_t take();
  void give_back(std::uint32_t slot);
  /// Keeps the living slots only, in order; returns for each new slot its old one.
  std::vector<std::uint32_t> compact();
  void reserve(std::size_t slots) { alive_.reserve(slots); }

  std::size_t slots() const { return alive_.size(); }
  std::size_t living() const { return alive_.size() - free_.size(); }
  bool is_alive(std::uint32_t slot) const { return slot < alive_.size() && alive_[slot]; }
  const std::vector<char>& alive() const { return alive_; }
  const std::vector<std::uint32_t>& free() const { return free_; }
  std::size_t memory_bytes() const { return alive_.capacity() + free_.capacity() * sizeof(std::uint32_t); }

 private:
  std::vector<char> alive_;
  std::vector<std::uint32_t> free_;
};

}  // namespace lostopos
