#include "FoamSim/render/film_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "shapes.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

// Half-planes around the z axis at the given azimuths (degrees), two triangles each.
Surface book(const std::vector<double>& azimuths, const std::vector<std::array<std::int32_t, 2>>& labels) {
  Surface s;
  s.positions = {{0, 0, 0}, {0, 0, 1}};
  for (std::size_t i = 0; i < azimuths.size(); ++i) {
    const double a = azimuths[i] * std::numbers::pi / 180;
    const auto v = static_cast<std::uint32_t>(s.positions.size());
    s.positions.emplace_back(std::cos(a), std::sin(a), 0);
    s.positions.emplace_back(std::cos(a), std::sin(a), 1);
    s.triangles.push_back({0, v, v + 1});
    s.triangles.push_back({0, v + 1, 1});
    s.labels.push_back(labels[i]);
    s.labels.push_back(labels[i]);
  }
  return s;
}

void expect_flat(const FilmMesh& mesh) {
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    for (const Vector3f& n : mesh.corner_normals[t]) EXPECT_LT((n - mesh.face_normals[t]).norm(), 1e-6f) << t;
}

TEST(FilmMesh, normals_are_not_averaged_across_a_plateau_border) {
  const FilmMesh mesh = prepare(book({0, 120, 240}, {{0, 1}, {1, 2}, {2, 0}}), Vector3d::Zero(), 1);
  ASSERT_EQ(mesh.triangles.size(), 6u);
  expect_flat(mesh);
  EXPECT_EQ(mesh.borders.size(), 1u);
  EXPECT_EQ(mesh.rims.size(), 9u);
}

TEST(FilmMesh, nor_even_between_films_of_one_region_pair_that_meet_there) {
  // Regions 1 and 2 on both sides of two opposite walls: a four-fold edge with equal pairs 10 degrees from one plane.
  const FilmMesh mesh = prepare(book({0, 85, 190, 265}, {{0, 1}, {1, 0}, {0, 1}, {1, 0}}), Vector3d::Zero(), 1);
  expect_flat(mesh);
  EXPECT_EQ(mesh.borders.size(), 1u);
}

TEST(FilmMesh, normals_are_averaged_within_a_bent_film) {
  // One page turned over, with its labels: still the same film.
  Surface s = book({0, 160}, {{0, 1}, {1, 0}});
  const FilmMesh mesh = prepare(s, Vector3d::Zero(), 1);
  EXPECT_TRUE(mesh.borders.empty());
  const double azimuth = 80 * std::numbers::pi / 180;
  const Vector3f bisector = Vector3d(std::cos(azimuth), std::sin(azimuth), 0).cast<float>();
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (int i = 0; i < 3; ++i) {
      const bool on_fold = mesh.triangles[t][i] < 2;
      const float along = std::abs(mesh.corner_normals[t][i].dot(bisector));
      EXPECT_NEAR(along, on_fold ? 1 : std::abs(mesh.face_normals[t].dot(bisector)), 2e-2) << t << ", " << i;
      EXPECT_GT(mesh.corner_normals[t][i].dot(mesh.face_normals[t]), 0.9f);
    }
  }
}

TEST(FilmMesh, sharp_creases_and_other_films_keep_their_own_normals) {
  expect_flat(prepare(book({0, 90}, {{0, 1}, {1, 0}}), Vector3d::Zero(), 1));
  expect_flat(prepare(book({0, 160}, {{0, 1}, {2, 0}}), Vector3d::Zero(), 1));
}

TEST(FilmMesh, normals_of_a_double_bubble_are_those_of_its_spheres_and_disc) {
  const FilmMesh mesh = prepare(double_bubble(48), Vector3d::Zero(), 1);
  EXPECT_EQ(mesh.borders.size(), 48u);
  EXPECT_TRUE(mesh.rims.empty());
  std::size_t on_rim = 0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& c = mesh.triangles[t];
    const float middle = (mesh.positions[c[0]] + mesh.positions[c[1]] + mesh.positions[c[2]]).x() / 3;
    for (int i = 0; i < 3; ++i) {
      const Vector3f& x = mesh.positions[c[i]];
      const Vector3f exact =
          std::abs(middle) < 1e-6f ? Vector3f::UnitX() : Vector3f(x - Vector3f(middle > 0 ? 0.5f : -0.5f, 0, 0));
      // At the rim the mean is one-sided: off by half a ring, 3.75 degrees; across the border it would be 30.
      EXPECT_GT(std::abs(mesh.corner_normals[t][i].dot(exact.normalized())), std::cos(0.07)) << t;
      on_rim += c[i] < 48;
    }
  }
  EXPECT_GT(on_rim, 0u);
}

TEST(FilmMesh, scene_units_and_mean_edge) {
  const FilmMesh mesh = prepare(book({0}, {{0, 1}}), {0, 0, 0.5}, 0.5);
  EXPECT_LT((mesh.positions[1] - Vector3f(0, 0, 1)).norm(), 1e-6f);
  EXPECT_NEAR(mesh.mean_edge, 2 * (4 + std::sqrt(2.0)) / 5, 1e-6);
}

TEST(FilmMesh, hidden_triangles_count_for_nothing) {
  Surface s = book({0, 120, 240}, {{0, 1}, {1, 2}, {2, 0}});
  s.hidden = {0, 0, 0, 0, 1, 1};
  const FilmMesh mesh = prepare(s, Vector3d::Zero(), 1);
  EXPECT_EQ(mesh.triangles.size(), 4u);
  EXPECT_TRUE(mesh.borders.empty());
}

TEST(FilmMesh, a_triangle_of_zero_area_opens_no_rim) {
  // A square split by a triangle squeezed flat onto its diagonal.
  Surface s;
  s.positions = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0.5, 0.5, 0}};
  s.triangles = {{0, 1, 2}, {0, 2, 4}, {0, 4, 3}, {4, 2, 3}};
  s.labels.assign(4, {1, 0});
  const FilmMesh mesh = prepare(s, Vector3d::Zero(), 1);
  EXPECT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.rims.size(), 4u);
  expect_flat(mesh);
}

}  // namespace
}  // namespace foamsim::render
