#include "FoamSim/run/run_writer.h"

#include "FoamSim/metrics/events_csv.h"
#include "FoamSim/metrics/metrics_csv.h"
#include "FoamSim/run/checkpoint.h"
#include "LosTopos/io/ply.h"
#include "LosTopos/io/vtp.h"

namespace foamsim {

namespace {

// A run taken up again goes on behind the checkpoint: what it wrote after it before is written anew.
std::vector<lostopos::PvdFrame> frames_until(const std::filesystem::path& pvd, double time) {
  std::vector<lostopos::PvdFrame> frames;
  if (!std::filesystem::exists(pvd)) return frames;
  for (const lostopos::PvdFrame& frame : lostopos::read_pvd(pvd))
    if (frame.time <= time) frames.push_back(frame);
  return frames;
}

base::CsvTable table(const std::filesystem::path& file, const std::string& header, long resumed_step) {
  if (resumed_step >= 0) base::keep_rows_until(file, resumed_step);
  return {file, header, resumed_step >= 0};
}

bool due(long step, long every) {
  return every > 0 && step % every == 0;
}

// All named fields that are numbers, and the circulation at the triangles' corners, averaged.
lostopos::SurfaceData with_circulation(const Simulation& simulation) {
  lostopos::SurfaceData data = lostopos::from_mesh_with_attributes(simulation.mesh());
  lostopos::DataArray mean{"circulation", 1, {}};
  for (lostopos::Triangle t : simulation.mesh().triangles()) {
    const auto corners = corner_circulation(simulation.mesh(), simulation.circulation(), t);
    mean.values.push_back((corners[0] + corners[1] + corners[2]) / 3);
  }
  data.triangle_arrays.push_back(std::move(mean));
  return data;
}

}  // namespace

RunWriter::RunWriter(RunDirectory directory, const Scene& scene, long resumed_step)
    : directory_(std::move(directory)),
      metrics_(table(directory_.metrics_csv(), metrics_header(), resumed_step)),
      volumes_(table(directory_.volumes_csv(), volumes_header(), resumed_step)),
      pvd_(directory_.pvd(),
           frames_until(directory_.pvd(), static_cast<double>(resumed_step) * scene.options.number("dt"))),
      frame_every_(scene.options.whole("frame_every")),
      metrics_every_(scene.options.whole("metrics_every")),
      checkpoint_every_(scene.options.whole("checkpoint_every")),
      vtp_(scene.options.flag("vtp")) {
  if (scene.options.flag("topology.enabled")) events_ = table(directory_.events_csv(), events_header(), resumed_step);
  if (vtp_) std::filesystem::create_directories(directory_.path() / "vtp");
}

void RunWriter::write_start(const Simulation& simulation, const Metrics& metrics) {
  metrics_.add(metrics_row(metrics));
  volumes_.add(volumes_rows(metrics));
  write_frame(simulation);
}

void RunWriter::write_step(const Scene& scene, const Simulation& simulation, const Metrics& metrics,
                           const std::vector<lostopos::RegionVolume>& start_volumes,
                           const lostopos::Vec3& start_centroid) {
  if (due(metrics.step, metrics_every_)) {
    metrics_.add(metrics_row(metrics));
    volumes_.add(volumes_rows(metrics));
  }
  if (events_ && !metrics.events.empty()) events_->add(events_rows(metrics));
  if (due(metrics.step, frame_every_)) write_frame(simulation);
  if (due(metrics.step, checkpoint_every_)) write_checkpoint(scene, simulation, start_volumes, start_centroid);
}

void RunWriter::write_frame(const Simulation& simulation) {
  const auto file = directory_.frame(simulation.steps());
  if (file == last_frame_) return;
  lostopos::write_ply(file, lostopos::from_mesh(simulation.mesh()));
  last_frame_ = file;
  if (vtp_) write_vtp(simulation);
}

void RunWriter::write_vtp(const Simulation& simulation) {
  const auto file = directory_.vtp(simulation.steps());
  lostopos::write_vtp(file, with_circulation(simulation));
  pvd_.add(simulation.time(), file.lexically_relative(directory_.path()).string());
}

void RunWriter::write_checkpoint(const Scene& scene, const Simulation& simulation,
                                 const std::vector<lostopos::RegionVolume>& start_volumes,
                                 const lostopos::Vec3& start_centroid) {
  foamsim::write_checkpoint(directory_.checkpoint(), scene, simulation, start_volumes, start_centroid);
}

}  // namespace foamsim
