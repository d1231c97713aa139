// Cost of taking a mesh's state and of putting it back, in memory that is used again: what an undone step pays.
#include <chrono>
#include <cstdio>

#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/sheet/circulation.h"
#include "LosTopos/surface_tracker.h"

namespace {

template <class Work>
double microseconds_a_triangle(const lostopos::SurfaceMesh& mesh, const Work& work) {
  constexpr int rounds = 50;
  work();
  const auto start = std::chrono::steady_clock::now();
  for (int i = 0; i < rounds; ++i) work();
  const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - start;
  return taken.count() / rounds / static_cast<double>(mesh.triangle_count());
}

}  // namespace

int main() {
  for (const long n : {48L, 107L}) {
    lostopos::SurfaceTracker tracker(foamsim::double_bubble(n), {.resolution = 0.1, .topology = {.enabled = true}});
    const foamsim::CirculationField circulation(tracker.mesh());
    lostopos::SurfaceTracker::State state;
    const double save = microseconds_a_triangle(tracker.mesh(), [&] { tracker.save(state); });
    const double restore = microseconds_a_triangle(tracker.mesh(), [&] { tracker.restore(state); });
    std::printf("%zu triangles: save %.4f, restore %.4f microseconds a triangle\n", tracker.mesh().triangle_count(),
                save, restore);
  }
  return 0;
}
