// What a scene does not name is not made: objects are counted while a simulation is made and makes two steps.
#include <gtest/gtest.h>

#include <map>

#include "FoamSim/scenes/scene.h"

namespace foamsim {
namespace {

// By kind and name.
using Made = std::map<std::string, int>;

template <class Entry>
base::Registry<Entry> counted(const base::Registry<Entry>& registry, Made& made) {
  std::vector<Entry> entries(registry.begin(), registry.end());
  for (Entry& entry : entries)
    entry.make = [make = entry.make, name = registry.kind() + " " + entry.name, &made](const auto& setup) {
      auto product = make(setup);
      if (product) ++made[name];
      return product;
    };
  return base::Registry<Entry>(registry.kind(), std::move(entries));
}

Made made_by(const char* name, const std::vector<std::string>& assignments = {}) {
  Made made;
  auto catalogue = std::make_shared<Catalogue>(*built_in_catalogue());
  catalogue->sheet.areas = counted(catalogue->sheet.areas, made);
  catalogue->sheet.pressures = counted(catalogue->sheet.pressures, made);
  catalogue->sheet.velocities = counted(catalogue->sheet.velocities, made);
  catalogue->effects = counted(catalogue->effects, made);
  catalogue->constraints = counted(catalogue->constraints, made);
  catalogue->integrators = counted(catalogue->integrators, made);
  catalogue->dynamics = counted(catalogue->dynamics, made);
  Scene scene = built_in_scene(name, std::move(catalogue));
  for (const std::string& assignment : assignments) scene.options.set_assignment(assignment, "test");
  Simulation simulation = make_simulation(scene);
  for (int i = 0; i < 2; ++i) simulation.step();
  return made;
}

Made parts_of_the_vortex_sheet() {
  return {{"area strategy averaged", 1}, {"dynamics vortex-sheet", 1}, {"effect diffusion", 1},
          {"effect surface_tension", 1}, {"integrator euler", 1},      {"pressure scheme edge_angle", 1},
          {"velocity sum direct", 1}};
}

Made with(const char* more) {
  Made made = parts_of_the_vortex_sheet();
  ++made[more];
  return made;
}

TEST(OnlyWhatIsAsked, OfADoubleBubbleIsNeitherConstraintNorBlowing) {
  EXPECT_EQ(made_by("doublebubble", {"n=8"}), parts_of_the_vortex_sheet());
}

TEST(OnlyWhatIsAsked, OfASceneWithAWireIsTheWire) {
  EXPECT_EQ(made_by("constrainedsphere"), with("constraint wire"));
  EXPECT_EQ(made_by("sheet"), with("constraint rod"));
}

TEST(OnlyWhatIsAsked, OfTheConservativeDynamicsIsNoPartOfTheVortexSheet) {
  EXPECT_EQ(made_by("doublebubble", {"n=8", "dynamics=conservative"}), (Made{{"dynamics conservative", 1},
                                                                             {"effect surface_tension", 1},
                                                                             {"effect volumes", 1},
                                                                             {"velocity sum direct", 1}}));
}

// A frame that is named holds nothing here.
TEST(OnlyWhatIsAsked, OfAConstraintWithoutAnythingToHoldIsNothing) {
  EXPECT_EQ(made_by("doublebubble", {"n=8", "constraints=frame"}), parts_of_the_vortex_sheet());
}

}  // namespace
}  // namespace foamsim
