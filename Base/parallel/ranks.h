#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <utility>

namespace base {

/// The processes that make one run together (MPI's word). Each has all of its state and takes the same decisions; what
/// they share out is work whose results every one of them then gets, with the bits that one alone would have. All calls
/// are collective: every rank makes them, in the same order, from one thread.
class Ranks {
 public:
  Ranks() = default;
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;
  virtual ~Ranks() = default;

  virtual std::size_t size() const = 0;
  virtual std::size_t rank() const = 0;  ///< of this process, 0 to size − 1

  /// Fills in what others have written: each element is written by one rank, and 0 (all bits) on the others.
  virtual void gather(std::span<double> values) const = 0;
  /// Calls `add` on rank after rank, each with the values that the one before has left, and gives the last one's to
  /// all: a sum over parts in their order.
  virtual void in_turn(std::span<double> values, const std::function<void()>& add) const = 0;
  /// Whether it is true on any rank.
  virtual bool any(bool here) const = 0;

  /// This rank's share of `count` things, a first and a last less one: as many for each as can be.
  std::pair<std::size_t, std::size_t> share(std::size_t count) const {
    return {count * rank() / size(), count * (rank() + 1) / size()};
  }
};

/// One process by itself.
std::shared_ptr<const Ranks> alone();

}  // namespace base
