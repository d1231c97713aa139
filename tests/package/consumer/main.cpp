#include <FoamSim/app/run_program.h>
#include <FoamSim/scenes/scene.h>
#include <FoamSim/scenes/shapes/solids.h>

#include <nlohmann/json.hpp>

// Somebody else's program: an effect with an option and a state of its own, an area strategy and a scene, by name,
// under the same command line.
namespace {

using namespace foamsim;

// Blows all vertices along x, more every step, and dyes the films.
class Wind final : public Effect {
 public:
  explicit Wind(double speed) : speed_(speed) {}
  std::string_view name() const override { return "wind"; }
  void attach(lostopos::SurfaceMesh& mesh) override {
    dye_.emplace(mesh.add_vertex_attribute<double>("dye", lostopos::carry::conserve, 0.0));
  }
  void update_circulation(const EffectStep& step, CirculationField&) override {
    ++gusts_;
    for (lostopos::Vertex v : step.mesh.vertices()) (*dye_)[v] += step.dt * step.mesh.position(v).x();
  }
  void add_velocity(const Stage&, std::span<lostopos::Vec3> velocity) override {
    for (lostopos::Vec3& u : velocity) u.x() += speed_ * static_cast<double>(gusts_);
  }
  nlohmann::json state() const override { return gusts_; }
  void restore(const nlohmann::json& state) override { gusts_ = state; }

 private:
  double speed_;
  long gusts_ = 0;
  std::optional<lostopos::VertexAttribute<double>> dye_;
};

// One area for every region at a vertex, a number of times that of its triangles.
class CrudeArea final : public VertexArea {
 public:
  explicit CrudeArea(double factor) : factor_(factor) {}
  void evaluate(const VertexStar& star, std::span<double> area) const override {
    double sum = 0;
    for (lostopos::Triangle t : star.mesh.triangles(star.vertex)) sum += star.geometry.area(t);
    std::ranges::fill(area, factor_ * sum);
  }

 private:
  double factor_;
};

std::shared_ptr<const Catalogue> catalogue() {
  auto mine = std::make_shared<Catalogue>(*built_in_catalogue());
  mine->effects.add({"wind",
                     "blows along x, more every step",
                     {base::non_negative_number("wind", 1, "speed, L/T")},
                     [](const EffectSetup& setup) { return std::make_unique<Wind>(setup.options.number("wind")); }});
  mine->sheet.areas.add(
      {"crude",
       "some times the area of the triangles",
       {base::positive_number("crude", 0.3, "how many times")},
       [](const VertexAreaSetup& setup) { return std::make_unique<CrudeArea>(setup.options.number("crude")); }});
  mine->scenes.add({"pebble",
                    "a small bubble",
                    {base::positive_number("pebble", 0.5, "its radius, L")},
                    {{"frame_every", 4L}},
                    [](const base::OptionSet& options) { return icosphere(2, options.number("pebble")); }});
  return mine;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program(argc, argv, catalogue());
}
