#include "FoamSim/scenes/relaxed_start.h"

#include "FoamSim/dynamics/relaxation.h"
#include "FoamSim/effects/surface_tension.h"
#include "FoamSim/effects/volumes.h"
#include "LosTopos/io/mesh_file.h"

namespace foamsim {

lostopos::SurfaceMesh relaxed_start(lostopos::SurfaceMesh surface, const SimulationOptions& options, double sigma,
                                    long steps, const RelaxationProgress& progress) {
  SimulationParts parts;
  parts.dynamics = std::make_unique<Relaxation>();
  parts.effects.push_back(std::make_unique<SurfaceTension>(sigma, nullptr));
  parts.effects.push_back(std::make_unique<Volumes>());
  SimulationOptions own = options;
  own.dt = 0;
  Simulation simulation(std::move(surface), own, std::move(parts));
  for (long done = 0; done < steps; ++done) {
    simulation.step();
    if (progress && !progress(done + 1, steps)) break;
  }
  // Without attributes: at rest, nothing held.
  return lostopos::to_mesh(lostopos::from_mesh(simulation.mesh()));
}

}  // namespace foamsim
