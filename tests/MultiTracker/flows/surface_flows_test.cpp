#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/solids.h"
#include "MultiTracker/flows/alternating_flow.h"
#include "MultiTracker/flows/face_offset.h"
#include "MultiTracker/flows/mean_curvature.h"
#include "MultiTracker/flows/normal_flow.h"
#include "MultiTracker/flows/pulled_apart.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace multitracker {
namespace {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

std::vector<lostopos::Hold> nothing_held(const SurfaceMesh& mesh) {
  return std::vector<lostopos::Hold>(mesh.vertex_slots(), lostopos::Hold::none);
}

void move(SurfaceMesh& mesh, const SurfaceFlow& flow, double dt, const std::vector<lostopos::Hold>& held) {
  const auto ends = flow.predicted({mesh, held, 0, dt});
  for (Vertex v : mesh.vertices()) mesh.set_position(v, ends[v.index()]);
}

double mean_radius(const SurfaceMesh& mesh) {
  double sum = 0;
  for (Vertex v : mesh.vertices()) sum += mesh.position(v).norm();
  return sum / static_cast<double>(mesh.vertex_count());
}

double volume_of(const SurfaceMesh& mesh, Region region) {
  for (const auto& [r, volume] : lostopos::region_volumes(mesh))
    if (r == region) return volume;
  return 0;
}

TEST(NormalFlow, ASphereGrowsByItsSpeed) {
  SurfaceMesh sphere = lostopos::icosphere(3);
  for (int i = 0; i < 10; ++i) move(sphere, NormalFlow(2), 0.01, nothing_held(sphere));
  EXPECT_NEAR(mean_radius(sphere), 1.2, 1e-3);
}

// What has air on one side only at its rim: the wall between the bubbles stays, and so does its inside.
TEST(NormalFlow, FilmsBetweenRegionsStay) {
  SurfaceMesh bubbles = lostopos::test::analytic_double_bubble(1, 24);
  const SurfaceMesh start = bubbles.clone();
  move(bubbles, NormalFlow(1), 0.01, nothing_held(bubbles));
  for (Vertex v : bubbles.vertices()) {
    const double way = (bubbles.position(v) - start.position(v)).norm();
    const auto around = start.triangles(v);
    const bool at_air =
        std::ranges::any_of(around, [&](lostopos::Triangle t) { return start.labels(t).has(lostopos::air); });
    EXPECT_NEAR(way, at_air ? 0.01 : 0, 1e-12);
    EXPECT_EQ(NormalFlow(1).still_moves({start, nothing_held(start), 0, 0.01}, v), at_air);
  }
}

TEST(FaceOffset, FlatFacesMoveByTheOffsetAndCornersNoFarther) {
  SurfaceMesh cube = lostopos::cube(3);
  const double side = -cube.position(Vertex(0)).x(), offset = 0.05;
  const SurfaceMesh start = cube.clone();
  move(cube, FaceOffsetFlow(PairSpeeds(1)), offset, nothing_held(cube));
  for (Vertex v : cube.vertices()) {
    const Vec3 way = cube.position(v) - start.position(v);
    EXPECT_LE(way.norm(), offset * (1 + 1e-9));
    const auto on_faces = (start.position(v).cwiseAbs().array() > side * (1 - 1e-9)).count();
    EXPECT_NEAR(way.norm(), offset, 1e-9) << "on " << on_faces << " faces";
  }
}

// Shrinking faces run into each other: creases and corners are where the moved planes meet.
TEST(FaceOffset, AShrinkingCubeStaysACube) {
  SurfaceMesh cube = lostopos::cube(3);
  const double side = -cube.position(Vertex(0)).x();
  for (int i = 0; i < 4; ++i) move(cube, FaceOffsetFlow(PairSpeeds(-1)), 0.02, nothing_held(cube));
  EXPECT_NEAR(volume_of(cube, Region(1)), std::pow(2 * (side - 0.08), 3), 1e-9);
}

TEST(FaceOffset, SpeedsBelongToPairsAndTurnWithThem) {
  PairSpeeds speeds(2);
  speeds.set(Region(1), Region(2), 3);
  EXPECT_EQ(speeds.along_normal({Region(1), Region(2)}), 3);
  EXPECT_EQ(speeds.along_normal({Region(2), Region(1)}), -3);
  EXPECT_EQ(speeds.along_normal({Region(1), lostopos::air}), 2);
  EXPECT_EQ(speeds.along_normal({lostopos::air, Region(1)}), -2);
  EXPECT_EQ(speeds.along_normal({Region(1), Region(3)}), 0);
  // Region 1 grows into 2 by the wall's area times the offset.
  SurfaceMesh bubbles = lostopos::test::analytic_double_bubble(1, 48);
  PairSpeeds wall;
  wall.set(Region(1), Region(2), 1);
  const double before = volume_of(bubbles, Region(1)), both = before + volume_of(bubbles, Region(2));
  move(bubbles, FaceOffsetFlow(wall), 0.01, nothing_held(bubbles));
  const double gained = volume_of(bubbles, Region(1)) - before;
  EXPECT_GT(gained, 0.8 * 0.01 * 3.14 * 0.75);
  EXPECT_LT(gained, 1.05 * 0.01 * 3.15 * 0.75);
  EXPECT_NEAR(volume_of(bubbles, Region(1)) + volume_of(bubbles, Region(2)), both, 0.1 * gained);
}

// v = 2H: R² = R₀² − 4t.
TEST(MeanCurvature, ASphereShrinksAsItsRadius) {
  for (double dt : {0.01, 0.04}) {
    SurfaceMesh sphere = lostopos::icosphere(3);
    for (double t = 0; t < 0.119; t += dt) move(sphere, MeanCurvatureFlow(), dt, nothing_held(sphere));
    EXPECT_NEAR(mean_radius(sphere), std::sqrt(1 - 4 * 0.12), 5e-3) << "dt " << dt;
  }
}

TEST(MeanCurvature, TheAreaNeverRisesEvenInLongSteps) {
  SurfaceMesh bubbles = lostopos::test::analytic_double_bubble(1, 20);
  double area = lostopos::total_area(bubbles);
  for (int i = 0; i < 10; ++i) {
    move(bubbles, MeanCurvatureFlow(), 0.02, nothing_held(bubbles));
    EXPECT_LT(lostopos::total_area(bubbles), area);
    area = lostopos::total_area(bubbles);
  }
}

// Films that meet at 120 degrees are at rest, others turn towards it.
TEST(MeanCurvature, DrivesBordersTo120Degrees) {
  auto at_rest = lostopos::test::triple_junction({120, 120, 120});
  auto bent = lostopos::test::triple_junction({90, 120, 150});
  const Vertex middle = at_rest.border[3];
  std::vector<Vec3> ends = MeanCurvatureFlow().predicted({at_rest.mesh, nothing_held(at_rest.mesh), 0, 0.01});
  EXPECT_NEAR((ends[middle.index()] - at_rest.mesh.position(middle)).norm(), 0, 1e-12);
  ends = MeanCurvatureFlow().predicted({bent.mesh, nothing_held(bent.mesh), 0, 0.01});
  const Vec3 way = ends[middle.index()] - bent.mesh.position(middle);
  const Vec3 pull = bent.direction[0] + bent.direction[1] + bent.direction[2];
  EXPECT_GT(way.dot(pull), 0.99 * way.norm() * pull.norm());
  EXPECT_GT(way.norm(), 1e-4);
}

TEST(HeldCoordinates, StayInEveryFlow) {
  const SurfaceMesh sphere = lostopos::icosphere(2);
  std::vector<lostopos::Hold> held = nothing_held(sphere);
  held[3] = lostopos::Hold::all;
  held[7] = lostopos::Hold::x | lostopos::Hold::z;
  const MeanCurvatureFlow curvature;
  const NormalFlow normal(1);
  const FaceOffsetFlow offset(PairSpeeds(1));
  for (const SurfaceFlow* flow : std::initializer_list<const SurfaceFlow*>{&curvature, &normal, &offset}) {
    const auto ends = flow->predicted({sphere, held, 0, 0.01});
    EXPECT_EQ(ends[3], sphere.position(Vertex(3)));
    EXPECT_EQ(ends[7].x(), sphere.position(Vertex(7)).x());
    EXPECT_EQ(ends[7].z(), sphere.position(Vertex(7)).z());
    EXPECT_NE(ends[7].y(), sphere.position(Vertex(7)).y());
  }
  const auto pulled = PulledApartFlow(std::make_unique<NormalFlow>(1), 0.5).predicted({sphere, held, 0, 0.01});
  const Vec3& start = sphere.position(Vertex(3));
  EXPECT_NEAR(pulled[3].x() - start.x(), std::copysign(0.005, start.x()), 1e-15);
}

TEST(AlternatingFlow, TakesTurns) {
  const SurfaceMesh sphere = lostopos::icosphere(1);
  std::vector<std::unique_ptr<SurfaceFlow>> flows;
  flows.push_back(std::make_unique<NormalFlow>(1));
  flows.push_back(std::make_unique<NormalFlow>(-1));
  const AlternatingFlow flow(std::move(flows), 0.3);
  for (int step = 0; step < 12; ++step) {
    const auto ends = flow.predicted({sphere, nothing_held(sphere), 0.1 * step, 0.1});
    EXPECT_EQ(ends[0].norm() > 1, step / 3 % 2 == 0) << "step " << step;
  }
}

}  // namespace
}  // namespace multitracker
