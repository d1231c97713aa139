#include "FoamSim/sheet/velocity/tree/chebyshev.h"

#include <cmath>
#include <numbers>

namespace foamsim {

Chebyshev::Chebyshev(std::size_t n) : size_(n) {
  for (std::size_t k = 0; k < n; ++k) {
    nodes_[k] = std::cos(std::numbers::pi * static_cast<double>(k) / static_cast<double>(n - 1));
    weights_[k] = (k % 2 == 0 ? 1.0 : -1.0) * (k == 0 || k == n - 1 ? 0.5 : 1.0);
  }
  for (std::size_t j = 0; j < n; ++j) {
    double sum = 0;
    for (std::size_t k = 0; k < n; ++k) {
      if (k == j) continue;
      slope_[j][k] = weights_[k] / weights_[j] / (nodes_[j] - nodes_[k]);
      sum += slope_[j][k];
    }
    slope_[j][j] = -sum;
  }
}

void Chebyshev::values(double s, Values& out) const {
  double sum = 0;
  for (std::size_t k = 0; k < size_; ++k) {
    const double distance = s - nodes_[k];
    if (distance == 0) {
      out = {};
      out[k] = 1;
      return;
    }
    out[k] = weights_[k] / distance;
    sum += out[k];
  }
  for (std::size_t k = 0; k < size_; ++k) out[k] /= sum;
}

void Chebyshev::slopes(const Values& values, Values& out) const {
  for (std::size_t k = 0; k < size_; ++k) {
    out[k] = 0;
    for (std::size_t j = 0; j < size_; ++j) out[k] += values[j] * slope_[j][k];
  }
}

}  // namespace foamsim
