#include "FoamSim/studies/stability/motions.h"

#include <algorithm>
#include <cmath>

#include "FoamSim/metrics/junction_angles.h"
#include "FoamSim/run/simulation_motion.h"
#include "FoamSim/scenes/methods.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Vec3;

namespace {

Scene scene_for(const CaseSetup& setup) {
  Scene scene = built_in_scene("doublebubble");
  choose_method(scene.options, setup.area, "stability study");
  scene.options.set("remeshing.enabled", setup.remeshing, "stability study");
  scene.options.set("topology.enabled", setup.remeshing, "stability study");
  for (const std::string& assignment : setup.assignments) scene.options.set_assignment(assignment, "--set");
  return scene;
}

class PrescribedMotion final : public MeasuredMotion {
 public:
  PrescribedMotion(SurfaceMesh mesh, const lostopos::TrackerOptions& options, double dt,
                   std::function<Vec3(const Vec3&)> flow)
      : tracker_(std::move(mesh), options),
        dt_(dt),
        flow_(std::move(flow)),
        start_volumes_(lostopos::region_volumes(tracker_.mesh())),
        metrics_(measured()) {}

  void step() override {
    const auto positions = mesh().positions();
    predicted_.assign(positions.begin(), positions.end());
    for (lostopos::Vertex v : mesh().vertices()) predicted_[v.index()] = flow_(mesh().position(v));
    lostopos::TrackerStep done = tracker_.step(predicted_);
    totals_.add(done.topology);
    work_ = {{}, done.move.statistics, std::move(done.topology), done.remesh};
    ++steps_;
    metrics_ = measured();
  }
  long steps() const override { return steps_; }
  double time() const override { return static_cast<double>(steps_) * dt_; }
  const SurfaceMesh& mesh() const override { return tracker_.mesh(); }
  const lostopos::run::StepWork& last() const override { return work_; }
  const Metrics& metrics() const override { return metrics_; }

 private:
  Metrics measured() const {
    const JunctionAngles angles = junction_angles(mesh());
    Metrics m;
    m.step = steps_;
    m.time = time();
    m.vertices = mesh().vertex_count();
    m.triangles = mesh().triangle_count();
    m.volumes = lostopos::region_volumes(mesh());
    m.regions = m.volumes.size();
    m.area = lostopos::total_area(mesh());
    m.centroid = lostopos::surface_centroid(mesh());
    m.angle_rms_deg = angles.rms_deviation_deg;
    m.angle_outer_mean_deg = angles.outer_mean_deg;
    m.volume_drift_max = lostopos::largest_volume_drift(m.volumes, start_volumes_);
    m.triangle_angle_min_deg = smallest_triangle_angle(mesh());
    m.topology_totals = totals_;
    return m;
  }

  lostopos::SurfaceTracker tracker_;
  double dt_;
  std::function<Vec3(const Vec3&)> flow_;
  std::vector<lostopos::RegionVolume> start_volumes_;
  std::vector<Vec3> predicted_;
  TopologyTotals totals_;
  long steps_ = 0;
  lostopos::run::StepWork work_;
  Metrics metrics_;
};

}  // namespace

std::unique_ptr<MeasuredMotion> simulated(const CaseSetup& setup, SurfaceMesh mesh, const SimulatedOptions& options) {
  Scene scene = scene_for(setup);
  if (!scene.options.is_set("dt")) scene.options.set("dt", options.dt, "stability study");
  scene.options.set("sigma", options.sigma, "stability study");
  if (scene.options.is_set("viscosity"))
    scene.options.set("viscosity", options.viscosity * scene.options.number("viscosity"), "stability study");
  const double resolution = options.resolution > 0 ? options.resolution : lostopos::mean_edge_length(mesh);
  Simulation simulation = make_simulation(scene, std::move(mesh), resolution, {});
  if (options.circulation) options.circulation(simulation.mesh(), simulation.circulation());
  auto volumes = lostopos::closed_region_volumes(simulation.mesh());
  return std::make_unique<SimulationMotion>(std::move(simulation), std::move(volumes));
}

std::unique_ptr<MeasuredMotion> prescribed(const CaseSetup& setup, SurfaceMesh mesh, double dt,
                                           std::function<Vec3(const Vec3&)> flow) {
  lostopos::TrackerOptions options = simulation_options(scene_for(setup).options).tracker;
  options.resolution = lostopos::mean_edge_length(mesh);
  return std::make_unique<PrescribedMotion>(std::move(mesh), options, dt, std::move(flow));
}

long scaled_steps(long steps, const CaseSetup& setup) {
  return std::max(10L, std::lround(static_cast<double>(steps) * setup.steps_scale));
}

std::vector<CaseRun> one_run(const CaseSetup& setup, std::unique_ptr<MeasuredMotion> (*start)(const CaseSetup&),
                             long steps) {
  return {{"", [setup, start] { return start(setup); }, scaled_steps(steps, setup)}};
}

}  // namespace foamsim
