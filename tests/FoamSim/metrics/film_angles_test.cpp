// The films' angles and the facets' on meshes sampled from double bubbles in closed form, where all angles are 120°.
#include "FoamSim/metrics/film_angles.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <cstdio>

#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/exact_double_bubble.h"
#include "FoamSim/scenes/shapes/solids.h"
#include "LosTopos/mesh/measures.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;
using lostopos::test::triple_junction;

// Slope of log error over log h from the coarsest to the finest.
double order(const std::vector<double>& h, const std::vector<double>& error) {
  return std::log(error.front() / error.back()) / std::log(h.front() / h.back());
}

struct Convergence {
  std::vector<double> h, facets, films;
};

Convergence on_exact_meshes(double volume0, double volume1) {
  const DoubleBubbleEquilibrium equilibrium = double_bubble_equilibrium(volume0, volume1);
  Convergence c;
  for (long segments : {16L, 24L, 48L, 96L}) {
    const SurfaceMesh mesh = exact_double_bubble(equilibrium, segments);
    c.h.push_back(lostopos::mean_edge_length(mesh));
    c.facets.push_back(*junction_angles(mesh).rms_deviation_deg);
    c.films.push_back(*film_angles(mesh).rms_deviation_deg);
    std::printf("volumes %g and %g, %ld segments: facets %.3f, films %.5f degrees\n", volume0, volume1, segments,
                c.facets.back(), c.films.back());
  }
  return c;
}

TEST(FilmAngles, AreOfSecondOrderOnExactDoubleBubbles) {
  for (double volume1 : {1.0, 2.0}) {
    const Convergence c = on_exact_meshes(1, volume1);
    EXPECT_GT(order(c.h, c.films), 1.8);
    EXPECT_LT(c.films[0], 2);
    EXPECT_LT(c.films[3], 0.02);
  }
}

TEST(FilmAngles, FacetsScoreSeveralDegreesOnTheSameMeshes) {
  const Convergence c = on_exact_meshes(1, 1);
  const std::array expected{9.4, 6.2, 3.1, 1.5};
  for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(c.facets[i], expected[i], 0.08 * expected[i]);
  EXPECT_NEAR(order(c.h, c.facets), 1, 0.1);
}

TEST(FilmAngles, OfFlatFilmsAreThoseOfTheirFacets) {
  for (const auto& degrees :
       {std::array{120.0, 120.0, 120.0}, std::array{90.0, 120.0, 150.0}, std::array{100.0, 125.0, 135.0}}) {
    SurfaceMesh mesh = triple_junction(degrees, 1, 3).mesh;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(1.2, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    for (Vertex v : mesh.vertices()) mesh.set_position(v, turn * mesh.position(v) + Vec3(3, 2, 1));
    const FilmAngles films = film_angles(mesh);
    const JunctionAngles facets = junction_angles(mesh);
    ASSERT_TRUE(films.rms_deviation_deg && films.outer_mean_deg);
    EXPECT_EQ(films.vertices, 5U) << "the border's ends are left out";
    EXPECT_NEAR(*films.rms_deviation_deg, *facets.rms_deviation_deg, 1e-10);
    EXPECT_NEAR(*films.outer_mean_deg, degrees[0], 1e-10);
  }
}

TEST(FilmAngles, FindTheDeviationOfTwoSpheresAtAnyAngle) {
  // The report's start shape: spheres that overlap by 45°, so that the outer angle is 45° and the others 157.5°.
  const double rms = std::sqrt((75 * 75 + 2 * 37.5 * 37.5) / 3);
  const FilmAngles angles = film_angles(double_bubble(96));
  EXPECT_EQ(angles.vertices, 96U);
  EXPECT_NEAR(*angles.outer_mean_deg, 45, 0.05);
  EXPECT_NEAR(*angles.rms_deviation_deg, rms, 0.05);
}

TEST(FilmAngles, DoNotDependOnWhichSideATriangleIsListedFrom) {
  const SurfaceMesh mesh = exact_double_bubble(double_bubble_equilibrium(1, 2), 16);
  SurfaceMesh turned;
  for (Vertex v : mesh.vertices()) turned.add_vertex(mesh.position(v));
  for (Triangle t : mesh.triangles()) {
    const auto [a, b, c] = mesh.vertices(t);
    if (t.index() % 3 == 0)
      turned.add_triangle(b, a, c, mesh.labels(t).flipped());
    else
      turned.add_triangle(a, b, c, mesh.labels(t));
  }
  EXPECT_NEAR(*film_angles(turned).rms_deviation_deg, *film_angles(mesh).rms_deviation_deg, 1e-9);
  EXPECT_NEAR(*film_angles(turned).outer_mean_deg, *film_angles(mesh).outer_mean_deg, 1e-9);
}

TEST(FilmAngles, WithoutBordersThereAreNone) {
  const FilmAngles angles = film_angles(icosphere(1));
  EXPECT_FALSE(angles.rms_deviation_deg);
  EXPECT_FALSE(angles.outer_mean_deg);
  EXPECT_EQ(angles.vertices, 0U);
}

}  // namespace
}  // namespace foamsim
