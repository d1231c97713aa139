// An effect of one's own: films carry a thickness that drains downwards and that stretching does not create: its
// integral over the films stays what it was in every change of the mesh.
#include <FoamSim/app/run_program.h>

#include <nlohmann/json.hpp>

namespace {

using namespace foamsim;

class Drain final : public Effect {
 public:
  explicit Drain(double rate) : rate_(rate) {}
  std::string_view name() const override { return "drain"; }

  // A named attribute follows the mesh, is written to .vtp, and is in checkpoints.
  void attach(lostopos::SurfaceMesh& mesh) override {
    thickness_.emplace(mesh.add_vertex_attribute<double>("thickness", lostopos::carry::conserve, 1.0));
  }

  void update_circulation(const EffectStep& step, CirculationField&) override {
    for (lostopos::Vertex v : step.mesh.vertices()) {
      double& here = (*thickness_)[v];
      const double before = here;
      here *= 1 - rate_ * step.dt * (1 + step.mesh.position(v).z());
      drained_ += before - here;
    }
  }

  // What it remembers besides attributes: kept in checkpoints, put back when a step fails.
  nlohmann::json state() const override { return drained_; }
  void restore(const nlohmann::json& state) override { drained_ = state; }

 private:
  double rate_;
  double drained_ = 0;
  std::optional<lostopos::VertexAttribute<double>> thickness_;
};

}  // namespace

int main(int argc, char** argv) {
  auto catalogue = std::make_shared<Catalogue>(*built_in_catalogue());
  catalogue->effects.add(
      {"drain",
       "films get thinner, more at the top",
       {base::non_negative_number("drain", 0.1, "rate, 1/T")},
       [](const EffectSetup& setup) { return std::make_unique<Drain>(setup.options.number("drain")); }});
  return run_program(argc, argv, catalogue);
}
