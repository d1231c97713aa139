#pragma once

#include <iterator>
#include <vector>

#include "LosTopos/mesh/handles.h"

namespace lostopos {

/// The living elements of one kind, in slot order. Adding or removing elements while iterating is not allowed.
template <class H>
class ElementRange {
 public:
  explicit ElementRange(const std::vector<char>& alive) : alive_(&alive) {}

  class Iterator {
   public:
    using value_type = H;
    using difference_type = std::ptrdiff_t;
    using iterator_category = std::forward_iterator_tag;
    Iterator() = default;
    Iterator(const std::vector<char>* alive, std::size_t slot) : alive_(alive), slot_(slot) { skip_dead(); }
    H operator*() const { return H(slot_); }
    Iterator& operator++() {
      ++slot_;
      skip_dead();
      return *this;
    }
    Iterator operator++(int) {
      Iterator before = *this;
      ++*this;
      return before;
    }
    bool operator==(const Iterator& other) const { return slot_ == other.slot_; }

   private:
    void skip_dead() {
      while (slot_ < alive_->size() && !(*alive_)[slot_]) ++slot_;
    }
    const std::vector<char>* alive_ = nullptr;
    std::size_t slot_ = 0;
  };

  Iterator begin() const { return {alive_, 0}; }
  Iterator end() const { return {alive_, alive_->size()}; }

 private:
  const std::vector<char>* alive_;
};

}  // namespace lostopos
