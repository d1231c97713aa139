#pragma once

#include <Eigen/Core>
#include <vector>

namespace foamsim::render {

/// Refractive index of soapy water.
inline constexpr double kFilmIndex = 1.33;

/// Part of unpolarised light of one wavelength that a plane film in air reflects, all internal reflections included
/// (Airy): per polarisation, with r the Fresnel amplitude of one face and β = 2π n d cosθ_t / λ,
/// R = 4 r² sin²β / ((1 − r²)² + 4 r² sin²β)   (Born & Wolf, Principles of Optics, section 7.6). The film absorbs
/// nothing: the part let through is 1 − R.
/// @param cos_theta  cosine of the angle of incidence, in [0, 1]; 0 gives 1 for any film of positive thickness.
/// @param thickness  d ≥ 0 and @param wavelength λ > 0, both in the same unit (nm).
double film_reflectance(double cos_theta, double thickness, double wavelength, double index = kFilmIndex);

/// Film reflectance as linear sRGB, tabulated over angle and thickness. A reflectance of 1 at all wavelengths is white.
class FilmColorTable {
 public:
  /// @param max_thickness  largest thickness that will be looked up, nm.
  explicit FilmColorTable(double max_thickness);

  /// Bilinear look-up, each channel in [0, 1]; arguments outside the table are clamped to it.
  Eigen::Vector3f reflectance(float cos_theta, float thickness) const;

 private:
  static constexpr int kAngles = 96;
  static constexpr int kThicknesses = 384;

  const Eigen::Vector3f& entry(int angle, int thickness) const { return table_[angle * kThicknesses + thickness]; }

  float max_thickness_;
  std::vector<Eigen::Vector3f> table_;
};

}  // namespace foamsim::render
