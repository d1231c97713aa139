#pragma once

#include "FoamSim/run/checkpoint.h"
#include "FoamSim/run/simulation_motion.h"

namespace foamsim {

/// The simulation of a scene: what a run of it writes and keeps.
class SceneMotion final : public SimulationMotion {
 public:
  /// From where, and what came before.
  struct Beginning {
    Scene scene;
    Simulation simulation;
    StartOfRun start;
    std::optional<StepReport> before = {};
    std::deque<RestDetector::Sample> quiet = {};
  };
  static Beginning beginning_of(const Scene& scene, const RelaxationProgress& progress = {},
                                const base::Interruption& interruption = {});
  static Beginning beginning_of(Checkpoint checkpoint, const base::Interruption& interruption = {});
  /// From a checkpoint's file. Throws base::FileError when it cannot be read, and base::InputError, naming it, for
  /// anything that is not a whole checkpoint of this version. `catalogue`: what its names mean.
  static Beginning beginning_of(const std::filesystem::path& checkpoint,
                                const std::shared_ptr<const Catalogue>& catalogue,
                                const base::Interruption& interruption = {});

  /// Throws base::InputError for a field to write that the scene does not have.
  explicit SceneMotion(Beginning beginning);

  void step() override;
  std::vector<lostopos::run::Table> tables() const override;
  /// With the vertices' velocities and lasting numbers where the option `frame_motion` asks for them.
  lostopos::SurfaceData frame() const override;
  /// With the fields that the option `fields` names.
  lostopos::SurfaceData picture() const override;
  /// With the circulation and what is held.
  lostopos::SurfaceData record() const override;
  bool resumable() const override { return true; }
  void save(nlohmann::json& checkpoint) const override;

  const Scene& scene() const { return scene_; }
  const StartOfRun& start() const { return start_; }
  /// After the last step; see RestDetector.
  bool at_rest() const { return at_rest_; }

 private:
  Scene scene_;
  StartOfRun start_;
  RestDetector rest_;
  bool at_rest_ = false;
};

}  // namespace foamsim
