#include "FoamSim/render/film_optics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace foamsim::render {
namespace {

struct Split {
  double reflected, passed;
};

// Oracle: the characteristic matrix of a layer (Abelès), from the fields' continuity rather than from Fresnel
// amplitudes. `inside` and `outside` are the tilted admittances of one polarisation.
Split characteristic_matrix(double inside, double outside, double phase) {
  const std::complex<double> i(0, 1);
  const std::complex<double> b = std::cos(phase) + i * std::sin(phase) / inside * outside;
  const std::complex<double> c = i * inside * std::sin(phase) + std::cos(phase) * outside;
  return {std::norm((outside * b - c) / (outside * b + c)), std::norm(2 * outside / (outside * b + c))};
}

Split oracle(double cosine, double thickness, double wavelength, double n) {
  const double inside = std::sqrt(1 - (1 - cosine * cosine) / (n * n));
  const double phase = 2 * std::numbers::pi * n * thickness * inside / wavelength;
  const Split s = characteristic_matrix(n * inside, cosine, phase);
  const Split p = characteristic_matrix(n / inside, 1 / cosine, phase);
  return {(s.reflected + p.reflected) / 2, (s.passed + p.passed) / 2};
}

TEST(FilmOptics, agrees_with_the_characteristic_matrix_and_conserves_energy) {
  for (const double wavelength : {420.0, 550.0, 690.0}) {
    for (const double cosine : {1.0, 0.9, 0.6, 0.3, 0.05}) {
      for (double thickness = 0; thickness < 1500; thickness += 37) {
        const Split expected = oracle(cosine, thickness, wavelength, kFilmIndex);
        EXPECT_NEAR(film_reflectance(cosine, thickness, wavelength), expected.reflected, 1e-12);
        EXPECT_NEAR(film_reflectance(cosine, thickness, wavelength) + expected.passed, 1, 1e-12);
      }
    }
  }
}

TEST(FilmOptics, known_values_at_normal_incidence) {
  const double n = kFilmIndex;
  EXPECT_NEAR(film_reflectance(1, 550 / (2 * n), 550), 0, 1e-15);  // half wave: invisible
  const double quarter = (n * n - 1) / (n * n + 1);
  EXPECT_NEAR(film_reflectance(1, 550 / (4 * n), 550), quarter * quarter, 1e-14);
  EXPECT_EQ(film_reflectance(1, 0, 550), 0);  // the black film
}

TEST(FilmOptics, grazing_incidence_reflects_everything) {
  EXPECT_NEAR(film_reflectance(0, 380, 550), 1, 1e-12);
  EXPECT_GT(film_reflectance(0.01, 300, 550), 0.9);
}

TEST(FilmColors, are_between_black_and_white) {
  const FilmColorTable table(800);
  for (float cosine = -0.1f; cosine < 1.1f; cosine += 0.013f) {
    for (float thickness = -10; thickness < 900; thickness += 7.3f) {
      const Eigen::Vector3f r = table.reflectance(cosine, thickness);
      ASSERT_TRUE((r.array() >= 0).all() && (r.array() <= 1).all()) << cosine << ", " << thickness << " nm";
    }
  }
}

TEST(FilmColors, grazing_is_white_and_no_thickness_is_black) {
  const FilmColorTable table(800);
  EXPECT_LT((table.reflectance(0, 400) - Eigen::Vector3f::Ones()).norm(), 1e-3f);
  EXPECT_LT(table.reflectance(1, 0).norm(), 1e-6f);
}

// A thick film shows no colour: the mean over a period of the phase is 1 − (1 − r)/(1 + r), r = ((n − 1)/(n + 1))².
TEST(FilmColors, thick_films_are_nearly_grey) {
  const FilmColorTable table(12000);
  const double face = std::pow((kFilmIndex - 1) / (kFilmIndex + 1), 2);
  const Eigen::Vector3f r = table.reflectance(1, 11900);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(r[i], 1 - (1 - face) / (1 + face), 0.004);
}

// Newton's colours of the first order: a film of about 100 nm is whitish, about 170 nm yellow-brown, about 220 nm blue
// to violet.
TEST(FilmColors, follow_the_order_of_newton) {
  const FilmColorTable table(800);
  const Eigen::Vector3f white = table.reflectance(1, 100);
  EXPECT_LT(white.maxCoeff() - white.minCoeff(), 0.25f * white.maxCoeff());
  const Eigen::Vector3f brown = table.reflectance(1, 170);
  EXPECT_GT(brown.x(), 2 * brown.z());
  const Eigen::Vector3f blue = table.reflectance(1, 230);
  EXPECT_GT(blue.z(), 2 * blue.y());
}

}  // namespace
}  // namespace foamsim::render
