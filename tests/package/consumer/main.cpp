#include <FoamSim/scenes/scene.h>

// A step of a built-in scene, as somebody else's program would make it.
int main() {
  const foamsim::Scene scene = foamsim::built_in_scene("doublebubble");
  foamsim::Simulation simulation = foamsim::make_simulation(scene);
  if (simulation.mesh().triangle_count() != 880) return 1;
  return simulation.step().velocity_evaluations == 1 ? 0 : 1;
}
