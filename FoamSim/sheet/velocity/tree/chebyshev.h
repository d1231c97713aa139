#pragma once

#include <array>
#include <cstddef>
#include <span>

namespace foamsim {

/// Most points of an interpolant along an axis.
inline constexpr std::size_t most_nodes = 16;

/// Barycentric Lagrange interpolation on [−1, 1] (Berrut and Trefethen 2004) at the Chebyshev points of the second kind
/// s_k = cos(π k / (n − 1)).
class Chebyshev {
 public:
  using Values = std::array<double, most_nodes>;

  /// n points, 2 to most_nodes.
  explicit Chebyshev(std::size_t n);

  std::size_t size() const { return size_; }
  double node(std::size_t k) const { return nodes_[k]; }
  /// L_k(s) for all k, −1 <= s <= 1.
  void values(double s, Values& out) const;
  /// L_k'(s), from the L_k(s): exact, for they are polynomials that the points determine.
  void slopes(const Values& values, Values& out) const;

 private:
  std::size_t size_;
  Values nodes_{}, weights_{};
  std::array<Values, most_nodes> slope_{};  // L_k'(s_j)
};

}  // namespace foamsim
