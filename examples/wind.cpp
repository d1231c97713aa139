#include <nlohmann/json.hpp>

#include "models.h"

namespace {

// A wind along +x in gusts: it carries everything with it at `wind` (L/T) times a strength that it remembers from step
// to step, and that fades by a tenth a step until the next gust comes. What it remembers is saved and resumed with the
// run, and put back when a step fails.
class Wind final : public foamsim::Effect {
 public:
  explicit Wind(double speed) : speed_(speed) {}
  std::string_view name() const override { return "wind"; }

  void update_circulation(const foamsim::EffectStep&, foamsim::CirculationField&) override {
    strength_ = strength_ < 0.5 ? 1 : 0.9 * strength_;
  }
  void add_velocity(const foamsim::Stage& stage, std::span<lostopos::Vec3> velocity) override {
    for (lostopos::Vertex v : stage.step.mesh.vertices()) velocity[v.index()].x() += speed_ * strength_;
  }

  nlohmann::json state() const override { return {{"strength", strength_}}; }
  void restore(const nlohmann::json& state) override { strength_ = state.at("strength").get<double>(); }

 private:
  double speed_;
  double strength_ = 0;
};

}  // namespace

foamsim::EffectEntry wind() {
  return {"wind",
          "carries the films along x, in gusts",
          {base::non_negative_number("wind", 0.5, "speed of a gust, L/T")},
          [](const foamsim::EffectSetup& setup) {
            return std::unique_ptr<foamsim::Effect>(std::make_unique<Wind>(setup.options.number("wind")));
          }};
}
