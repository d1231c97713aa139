#pragma once

#include <deque>
#include <filesystem>

#include "FoamSim/metrics/rest_detector.h"
#include "FoamSim/scenes/scene.h"
#include "LosTopos/run/checkpoint.h"

namespace foamsim {

/// The surface at the start of a run, which later ones are compared with.
struct StartOfRun {
  std::vector<lostopos::RegionVolume> volumes;  ///< of closed regions, L³
  lostopos::Vec3 centroid = lostopos::Vec3::Zero();
};

/// What a run needs to go on as if it had not stopped, to the bit.
struct Checkpoint {
  Scene scene;
  SimulationState state;
  double resolution = 0;  ///< h̄, L
  StartOfRun start;
  StepReport last;  ///< energies, impulse and motion fraction of the last step
  std::deque<RestDetector::Sample> quiet;
};

inline lostopos::run::CheckpointFormat checkpoint_format() {
  return {"foamsim", 6};
}

/// What a checkpoint holds of a run; `last`: of the step before it.
nlohmann::json checkpoint_content(const Scene& scene, const Simulation& simulation, const StartOfRun& start,
                                  const StepReport& last, const std::deque<RestDetector::Sample>& quiet);

/// What `content` holds of a run; `catalogue`: what its names mean. Throws base::Error for anything but what
/// checkpoint_content gives: options are checked as if they were given, the surface as SurfaceMesh::from_state does.
Checkpoint checkpoint_from(const nlohmann::json& content, std::shared_ptr<const Catalogue> catalogue);

/// The simulation that goes on from the checkpoint. Throws base::Error when its parts do not fit each other: options
/// that do not go together, attributes that are not those of the models or of the surface, a step or a resolution that
/// is not that of the options or out of all proportion to the surface.
Simulation resume(const Checkpoint& checkpoint, const base::Interruption& interruption = {});

}  // namespace foamsim
