#include "FoamSim/studies/reproduce/scene_gallery.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>

#include "tests/support/scratch_folder.h"

namespace foamsim {
namespace {

TEST(SceneGallery, ShowsEveryBuiltInSceneThatNeedsNoMesh) {
  const std::vector<GalleryScene> shown = gallery_scenes();
  for (const SceneEntry& entry : built_in_scenes())
    EXPECT_EQ(std::ranges::count(shown, entry.name, &GalleryScene::scene), entry.mesh_file ? 0 : 1) << entry.name;
  for (const GalleryScene& scene : shown) {
    EXPECT_FALSE(scene.figures.empty()) << scene.scene;
    for (const GalleryFigure& figure : scene.figures) EXPECT_LE(figure.time, scene.time) << scene.scene;
  }
}

TEST(SceneGallery, MeasuresAtItsTimesAndDrawsOnce) {
  const auto time = [](const Simulation& simulation) { return simulation.time(); };
  const GalleryScene scene{
      "barrel", 0.05, {"n=12"}, {{"late", 0.05, time, 0.05, 1e-9, ""}, {"early", 0.02, time, 0.03, 1e-9, ""}}};
  int pictures = 0;
  GalleryHooks hooks;
  hooks.picture = [&](const Simulation& simulation) {
    ++pictures;
    EXPECT_EQ(simulation.steps(), 5);
  };
  const std::vector<GalleryRow> rows = run_gallery_scene(scene, hooks);
  EXPECT_EQ(pictures, 1);
  ASSERT_EQ(rows.size(), 2U);
  EXPECT_EQ(rows[0].quantity, "early");
  EXPECT_NEAR(rows[0].measured, 0.02, 1e-12);
  EXPECT_FALSE(rows[0].holds());
  EXPECT_TRUE(rows[1].holds());
  const ::test::ScratchFolder folder;
  write_gallery(folder / "scenes.csv", rows);
  std::ifstream csv(folder / "scenes.csv");
  std::string header, first;
  std::getline(csv, header);
  std::getline(csv, first);
  EXPECT_EQ(header, "scene,quantity,time,measured,expected,tolerance,source,cpu_seconds");
  EXPECT_EQ(first.rfind("barrel,early,0.02,0.02,0.03,", 0), 0U) << first;
}

}  // namespace
}  // namespace foamsim
