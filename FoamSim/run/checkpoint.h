#pragma once

#include <filesystem>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

/// What a run needs to go on as if it had not stopped, to the bit.
struct Checkpoint {
  Scene scene;
  lostopos::SurfaceMesh mesh;  ///< with the values of its named attributes (circulation, hold, ...), which wait in it
  long step = 0;
  TopologyTotals topology;
  double resolution = 0;                              ///< h̄, L
  std::vector<lostopos::RegionVolume> start_volumes;  ///< at the start of the run
  lostopos::Vec3 start_centroid = lostopos::Vec3::Zero();
};

/// Writes the state of `simulation` to `file` (CBOR), atomically. Throws base::FileError.
void write_checkpoint(const std::filesystem::path& file, const Scene& scene, const Simulation& simulation,
                      const std::vector<lostopos::RegionVolume>& start_volumes, const lostopos::Vec3& start_centroid);

/// Throws base::InputError, naming the file, for anything that is not a whole checkpoint of a known version.
Checkpoint read_checkpoint(const std::filesystem::path& file);

/// The simulation that goes on from the checkpoint; takes the mesh out of it.
Simulation resume(Checkpoint& checkpoint);

}  // namespace foamsim
