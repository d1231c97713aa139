#pragma once

#include <cstdint>
#include <optional>
#include <vector>

namespace lostopos {

/// Finds elements by the numbers that a datafile gives them: any positive ones, in any order. Memory grows with the
/// elements, not with the numbers.
class FeNumbers {
 public:
  struct Entry {
    std::uint32_t number, index;
    std::size_t line;
  };

  const std::vector<Entry>& entries() const { return entries_; }
  /// The next element, from index 0, has that number; `line` is where, for messages.
  void add(std::uint32_t number, std::size_t line);
  /// To be called when all are there, before any is sought. The first number that stands twice, where it does again.
  std::optional<Entry> sort();
  /// Index of the element with that number, or minus it.
  std::optional<std::uint32_t> find(std::int64_t number) const;

 private:
  std::vector<Entry> entries_;
};

}  // namespace lostopos
