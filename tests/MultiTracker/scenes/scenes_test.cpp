#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <set>

#include "Base/error.h"
#include "MultiTracker/scenes/shapes/film_boxes.h"
#include "MultiTracker/scenes/shapes/slotted_disc.h"
#include "tests/MultiTracker/tracking_checks.h"
#include "tests/support/film_meshes.h"

namespace multitracker {
namespace {

using lostopos::Region;
using lostopos::SurfaceMesh;
using test::have_film;
using test::volume_of;

TEST(Scenes, StartCleanAndTakeAStep) {
  for (const SceneEntry& scene : scene_entries()) {
    SCOPED_TRACE(scene.name);
    Tracking tracking(Origin{.scene = &scene, .options = options_of(scene)});
    EXPECT_EQ(tracking.audit().text(), "clean");
    tracking.step();
    EXPECT_EQ(tracking.audit().text(), "clean");
    EXPECT_EQ(tracking.metrics().motion_fraction, 1);
    EXPECT_DOUBLE_EQ(tracking.metrics().time, tracking.dt());
  }
}

TEST(Scenes, KnowAboutHowLargeTheyAre) {
  for (const SceneEntry& scene : scene_entries()) {
    if (scene.triangles == nullptr) continue;
    const base::OptionSet options = options_of(scene);
    const auto there = static_cast<double>(own_surface(scene, options).triangle_count());
    EXPECT_GT(scene.triangles(options), 0.6 * there) << scene.name;
    EXPECT_LT(scene.triangles(options), 3 * there) << scene.name;
  }
}

TEST(Tracking, AStepThatIsInterruptedIsUndone) {
  const SceneEntry& scene = scene_by_name("normal-flow");
  std::size_t looks = 0, stop_at = 0;
  const auto start = [&] {
    return Tracking(Origin{.scene = &scene, .options = options_of(scene)}, {[&] { return ++looks == stop_at; }});
  };
  // Until a step has something to remesh or to keep apart: others have no loops to look in.
  Tracking undisturbed = start();
  for (int step = 0; step < 300 && looks < 4; ++step) {
    looks = 0;
    undisturbed.step();
  }
  const std::size_t all = looks;
  ASSERT_GT(all, 3U);
  Tracking tracking = start();
  while (tracking.steps() + 1 < undisturbed.steps()) tracking.step();
  const auto before = tracking.tracker().state();
  for (const std::size_t at : {std::size_t{1}, all / 3, all / 2, all}) {
    stop_at = at;
    looks = 0;
    EXPECT_THROW(tracking.step(), base::Interrupted) << at;
    EXPECT_EQ(tracking.steps() + 1, undisturbed.steps());
    EXPECT_TRUE(lostopos::test::same_bits(before, tracking.tracker().state())) << at;
  }
  stop_at = 0;
  tracking.step();
  EXPECT_TRUE(lostopos::test::same_bits(undisturbed.tracker().state(), tracking.tracker().state()));
}

TEST(Scenes, AnUnknownNameOrKeyIsAnErrorWithTheNearest) {
  const auto message_of = [](auto&& act) -> std::string {
    try {
      act();
    } catch (const base::InputError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_NE(message_of([] { scene_by_name("enrigt"); }).find("did you mean 'enright'"), std::string::npos);
  base::OptionSet options = options_of(scene_by_name("normal-flow"));
  EXPECT_NE(message_of([&] { options.set_assignment("sphere=3", "--set"); }).find("did you mean 'spheres'"),
            std::string::npos);
  EXPECT_NE(message_of([&] { options.set_assignment("layout=gird", "--set"); }).find("grid or random"),
            std::string::npos);
}

TEST(Scenes, HaveTheDefaultsOfPlainTrackingOrOfFilmsUnderTension) {
  for (const SceneEntry& scene : scene_entries()) {
    const base::OptionSet options = options_of(scene);
    const std::set<std::string_view> tension{"T1", "T2", "prism", "mcf", "catenoid"};
    const bool under_tension = tension.contains(scene.name);
    EXPECT_EQ(options.word("topology.separation"), under_tension ? "area" : "flow") << scene.name;
    EXPECT_EQ(options.number("remeshing.max_volume_change"), under_tension ? 1e-2 : 1e-4) << scene.name;
  }
}

TEST(Shapes, FourCellsFillTheirBox) {
  for (double gap : {0.0, 0.12}) {
    const SurfaceMesh mesh = four_cells({.gap = gap, .subdivisions = 1});
    EXPECT_NEAR(volume_of(mesh, 0), -1.2 * 0.6 * 0.6, 1e-12);
    EXPECT_EQ(have_film(mesh, 3, 4), gap > 0);
    EXPECT_FALSE(have_film(mesh, 1, 2));
    // Above: a triangle with base 1.2.
    EXPECT_NEAR(volume_of(mesh, 1), 0.5 * 1.2 * (0.6 - gap) / 2 * 0.6, 1e-12);
    EXPECT_NEAR(volume_of(mesh, 1), volume_of(mesh, 2), 1e-12);
    EXPECT_NEAR(volume_of(mesh, 3), volume_of(mesh, 4), 1e-12);
  }
}

TEST(Shapes, TheMiddleOfNestedTetrahedraScales) {
  const SurfaceMesh mesh = nested_tetrahedra(0.2, 1);
  const double whole = 8 * std::sqrt(3.0) / 27;  // of a tetrahedron with circumradius 1
  EXPECT_NEAR(volume_of(mesh, 5), whole * 0.008, 1e-12);
  for (std::size_t i = 1; i <= 4; ++i) EXPECT_NEAR(volume_of(mesh, i), whole * (1 - 0.008) / 4, 1e-12);
}

TEST(Shapes, ThreeCellsFillTheUnitBox) {
  const SurfaceMesh mesh = three_cells(2, 1);
  EXPECT_NEAR(volume_of(mesh, 0), -1, 1e-12);
  EXPECT_NEAR(volume_of(mesh, 2), 0.25 + 0.5 * 0.25, 1e-12);
  EXPECT_NEAR(volume_of(mesh, 1), volume_of(mesh, 3), 1e-12);
}

TEST(Shapes, TheSlottedDiscHasItsVolume) {
  const SlottedDiscOptions o{.segments = 256};
  const double r = o.radius, w = o.slot_width / 2;
  // The disc less the slot, which runs from the rim to its depth.
  const double rim = r * r * std::asin(w / r) + w * std::sqrt(r * r - w * w);  // 0 to the rim, within |x| < w
  const double slot = rim + 2 * w * (o.slot_depth - r);
  const double cap = r * r * std::asin(w / r) - w * std::sqrt(r * r - w * w);  // the rim over the slot is straight
  const double expected = (std::numbers::pi * r * r - slot - cap) * o.thickness;
  EXPECT_NEAR(volume_of(slotted_disc(o), 1) / expected, 1, 2e-4);
}

TEST(Metrics, RegionStatesCountFaces) {
  const auto states = region_states(nested_tetrahedra(0.2, 1));
  ASSERT_EQ(states.size(), 5u);
  for (const RegionState& state : states) {
    EXPECT_EQ(state.faces, 4u);
    EXPECT_EQ(state.touches_air, state.region != Region(5));
  }
}

}  // namespace
}  // namespace multitracker
