#pragma once

#include <Eigen/Core>
#include <cstdint>

namespace foamsim::render {

/// Film thickness as a smooth function of place: thinner on top, where films drain, with soft swirls.
class ThicknessField {
 public:
  /// @param mean  nm. @param variation  relative spread in [0, 1]. @param up  unit vector.
  ThicknessField(double mean, double variation, const Eigen::Vector3f& up);

  /// @param x  place, in units of half the picture's height, from the target. @param film  number that tells films
  /// apart.
  /// @return thickness in nm, in [0, max()].
  float operator()(const Eigen::Vector3f& x, std::uint32_t film) const;

  /// An upper bound of the thickness, nm.
  float max() const { return 2 * mean_; }

 private:
  float mean_;
  float variation_;
  Eigen::Vector3f up_;
};

/// A well-mixed 32-bit number from another (a bijection).
std::uint32_t hash(std::uint32_t x);

}  // namespace foamsim::render
