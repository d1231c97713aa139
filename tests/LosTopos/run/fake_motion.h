#pragma once

#include <nlohmann/json.hpp>

#include "LosTopos/error.h"
#include "LosTopos/run/run.h"

namespace lostopos::run::test {

/// One triangle that rises by 1 a step of 0.5 T.
class FakeMotion final : public Motion {
 public:
  explicit FakeMotion(long steps = 0) : steps_(steps) {
    std::array<Vertex, 3> corners{};
    for (std::size_t i = 0; i < 3; ++i)
      corners[i] = mesh_.add_vertex({i == 1 ? 1.0 : 0.0, i == 2 ? 1.0 : 0.0, static_cast<double>(steps)});
    (void)mesh_.add_triangle(corners[0], corners[1], corners[2], {Region(1), air});
  }
  /// As at the checkpoint of another.
  static FakeMotion resumed(const std::filesystem::path& file) {
    long steps = 0;
    read_checkpoint(file, {"fake", 1}, [&](const nlohmann::json& content) { steps = content.at("steps"); });
    return FakeMotion(steps);
  }

  void step() override {
    if (steps_ + 1 == fails_at) throw MotionError("stuck");
    if (steps_ + 1 == bad_input_at) throw base::InputError("no such thing");
    if (steps_ + 1 == interrupted_at) throw base::Interrupted("interrupted");
    ++steps_;
    for (Vertex v : mesh_.vertices()) mesh_.set_position(v, mesh_.position(v) + Vec3(0, 0, 1));
    work_ = {};
    work_.times.add("rise", 0.25);
    if (steps_ % 4 == 0) work_.topology.events.push_back({TopologyOperation::snap, {}, Vec3(0, 0, 1)});
  }
  long steps() const override { return steps_; }
  double time() const override { return 0.5 * static_cast<double>(steps_); }
  const SurfaceMesh& mesh() const override { return mesh_; }
  const StepWork& last() const override { return work_; }
  std::vector<Table> tables() const override {
    if (tables_fail) throw base::FileError("no tables here");
    return {{"metrics.csv", "step,time", 2,
             [this] { return std::to_string(steps_) + "," + std::to_string(time()) + "\n"; }}};
  }
  bool resumable() const override { return saved; }
  void save(nlohmann::json& checkpoint) const override { checkpoint["steps"] = steps_; }
  void summarize(nlohmann::ordered_json& run) const override { run["height"] = steps_; }

  long fails_at = -1, bad_input_at = -1, interrupted_at = -1;
  bool tables_fail = false, saved = true;

 private:
  SurfaceMesh mesh_;
  long steps_;
  StepWork work_;
};

}  // namespace lostopos::run::test
