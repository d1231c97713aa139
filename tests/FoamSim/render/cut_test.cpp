#include "FoamSim/render/cut.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

#include "Base/error.h"
#include "FoamSim/render/explode.h"
#include "FoamSim/render/film_mesh.h"
#include "FoamSim/render/render.h"
#include "shapes.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3d;

double area(const Surface& s) {
  double sum = 0;
  for (const auto& [a, b, c] : s.triangles)
    sum += 0.5 * (s.positions[b] - s.positions[a]).cross(s.positions[c] - s.positions[a]).norm();
  return sum;
}

TEST(Cut, leaves_what_lies_behind_the_plane) {
  const Surface whole = sphere(64, 1);
  const Surface half = cut(whole, {{0, 0, 2}, 0.4});          // z <= 0.2
  EXPECT_NEAR(area(half), 2 * std::numbers::pi * 1.2, 0.02);  // a cap's area is 2 pi R h
  for (const auto& triangle : half.triangles)
    for (const std::uint32_t v : triangle) EXPECT_LE(half.positions[v].z(), 0.2 + 1e-12);
}

TEST(Cut, of_neighbours_share_their_new_vertices) {
  const FilmMesh mesh = prepare(cut(double_bubble(24), {{0, 0, 1}, 0.013}), Vector3d::Zero(), 1);
  EXPECT_FALSE(mesh.borders.empty());
  // All free edges lie in the plane.
  for (const Segment& rim : mesh.rims)
    for (const auto& x : rim) EXPECT_NEAR(x.z(), 0.013f, 1e-6f);
}

TEST(Cut, away_shows_the_far_film_alone) {
  RenderOptions options;
  options.width = options.height = 41;
  options.background = Background::transparent;
  options.film_density = 0.5;
  options.boundary_tubes = false;
  const Surface whole = sphere(64, 1);
  const int two_films = render(whole, Camera{}, options).at(20, 20)[3];
  const int far_film = render(cut(whole, {{0, 0, 1}, 0}), Camera{}, options).at(20, 20)[3];
  EXPECT_LT(far_film, two_films);
  // Films let through products: what two equal ones do, one does half of it in the exponent.
  EXPECT_NEAR(1 - two_films / 255.0, std::pow(1 - far_film / 255.0, 2), 0.03);
}

TEST(Cut, refuses_planes_that_are_none_or_leave_nothing) {
  EXPECT_THROW(cut(sphere(8, 1), {{0, 0, 0}, 0}), base::InputError);
  EXPECT_THROW(cut(sphere(8, 1), {{0, 0, 1}, NAN}), base::InputError);
  EXPECT_THROW(cut(sphere(8, 1), {{0, 0, 1}, -2}), base::InputError);
}

TEST(Explode, gives_every_bubble_its_own_films_and_borders) {
  const Surface two = double_bubble(24);
  const Surface apart = explode(two, 1);
  EXPECT_EQ(apart.triangles.size(),
            two.triangles.size() + static_cast<std::size_t>(std::ranges::count_if(
                                       two.labels, [](const auto& pq) { return pq[0] * pq[1] != 0; })));
  // Bubbles about (-1/2, 0, 0) and (1/2, 0, 0), with a gap where they touched.
  for (const auto& triangle : apart.triangles)
    for (const std::uint32_t v : triangle) EXPECT_GT(std::abs(apart.positions[v].x()), 0.1);
  EXPECT_EQ(prepare(apart, Vector3d::Zero(), 1).borders.size(), 2 * prepare(two, Vector3d::Zero(), 1).borders.size());
  EXPECT_TRUE(prepare(apart, Vector3d::Zero(), 1).rims.empty());
}

TEST(Explode, by_nothing_moves_nothing) {
  for (const Surface still = explode(double_bubble(12), 0); const Vector3d& x : still.positions)
    EXPECT_LT(x.norm(), 1.6);
  EXPECT_THROW(explode(double_bubble(12), -1), base::InputError);
  EXPECT_THROW(explode(sphere(8, 1, {0, 0, 0}, 0, 0), 1), base::InputError);
}

}  // namespace
}  // namespace foamsim::render
