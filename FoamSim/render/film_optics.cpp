#include "FoamSim/render/film_optics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace foamsim::render {
namespace {

using Eigen::Vector3d;

// A Gaussian with different widths on its two sides.
double lobe(double x, double mean, double below, double above) {
  const double t = (x - mean) / (x < mean ? below : above);
  return std::exp(-0.5 * t * t);
}

// CIE 1931 colour matching functions: multi-lobe fit of Wyman, Sloan, Shirley, JCGT 2(2), 2013.
Vector3d matching_functions(double nm) {
  return {
      1.056 * lobe(nm, 599.8, 37.9, 31.0) + 0.362 * lobe(nm, 442.0, 16.0, 26.7) - 0.065 * lobe(nm, 501.1, 20.4, 26.2),
      0.821 * lobe(nm, 568.8, 46.9, 40.5) + 0.286 * lobe(nm, 530.9, 16.3, 31.1),
      1.217 * lobe(nm, 437.0, 11.8, 36.0) + 0.681 * lobe(nm, 459.0, 26.0, 13.8)};
}

struct Band {
  double wavelength;
  Vector3d weight;  // contribution of a unit reflectance to linear sRGB
};

constexpr int kBands = 81;  // 380 … 780 nm in steps of 5

std::array<Band, kBands> make_bands() {
  std::array<Band, kBands> bands;
  Vector3d sum = Vector3d::Zero();
  for (int i = 0; i < kBands; ++i) {
    const double nm = 380 + 5 * i;
    bands[i] = {nm, matching_functions(nm)};
    sum += bands[i].weight;
  }
  // XYZ scaled so that an equal-energy spectrum has sRGB's white point (D65), then the IEC 61966-2-1 matrix.
  const Vector3d white(0.95047, 1.0, 1.08883);
  Eigen::Matrix3d xyz_to_srgb;
  xyz_to_srgb << 3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108, 0.0415560, 0.0556434, -0.2040259, 1.0572252;
  for (Band& band : bands) band.weight = xyz_to_srgb * band.weight.cwiseQuotient(sum).cwiseProduct(white);
  return bands;
}

double airy(double r2, double sine2) {
  const double reflected = 4 * r2 * sine2;
  const double passed = (1 - r2) * (1 - r2);
  return reflected + passed > 0 ? reflected / (reflected + passed) : 1;
}

}  // namespace

double film_reflectance(double cos_theta, double thickness, double wavelength, double index) {
  const double ci = std::clamp(cos_theta, 0.0, 1.0);
  const double ct = std::sqrt(std::max(0.0, 1 - (1 - ci * ci) / (index * index)));
  const double rs = (ci - index * ct) / (ci + index * ct);
  const double rp = (index * ci - ct) / (index * ci + ct);
  const double sine = std::sin(2 * std::numbers::pi * index * thickness * ct / wavelength);
  return 0.5 * (airy(rs * rs, sine * sine) + airy(rp * rp, sine * sine));
}

FilmColorTable::FilmColorTable(double max_thickness) : max_thickness_(static_cast<float>(max_thickness)) {
  const std::array<Band, kBands> bands = make_bands();
  table_.reserve(kAngles * kThicknesses);
  for (int a = 0; a < kAngles; ++a) {
    const double s = static_cast<double>(a) / (kAngles - 1);
    for (int t = 0; t < kThicknesses; ++t) {
      const double thickness = max_thickness * t / (kThicknesses - 1);
      Vector3d rgb = Vector3d::Zero();
      for (const Band& band : bands) rgb += film_reflectance(s * s, thickness, band.wavelength) * band.weight;
      table_.push_back(rgb.cwiseMax(0.0).cwiseMin(1.0).cast<float>());
    }
  }
}

Eigen::Vector3f FilmColorTable::reflectance(float cos_theta, float thickness) const {
  // Angles are spaced by the square root of the cosine: reflectance rises steeply at grazing incidence.
  const float a = std::sqrt(std::clamp(cos_theta, 0.0f, 1.0f)) * (kAngles - 1);
  const float t = std::clamp(thickness / max_thickness_, 0.0f, 1.0f) * (kThicknesses - 1);
  const int a0 = std::min(static_cast<int>(a), kAngles - 2);
  const int t0 = std::min(static_cast<int>(t), kThicknesses - 2);
  const float u = a - static_cast<float>(a0);
  const float v = t - static_cast<float>(t0);
  return (1 - u) * ((1 - v) * entry(a0, t0) + v * entry(a0, t0 + 1)) +
         u * ((1 - v) * entry(a0 + 1, t0) + v * entry(a0 + 1, t0 + 1));
}

}  // namespace foamsim::render
