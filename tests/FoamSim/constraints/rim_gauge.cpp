#include "tests/FoamSim/constraints/rim_gauge.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

#include "FoamSim/sheet/sheet_strength.h"
#include "FoamSim/sheet/surface_geometry.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim::test {

using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;

namespace {

// An edge of the rim, in the sense in which the film's normal out of the bubble turns.
struct RimEdge {
  Vec3 start, end;
};

// Where one solid triangle and one of the film meet.
std::vector<RimEdge> rim(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  std::vector<RimEdge> edges;
  for (lostopos::Edge e : mesh.edges()) {
    const auto triangles = mesh.triangles(e);
    if (triangles.size() != 2 || is_solid(triangles[0], solid) == is_solid(triangles[1], solid)) continue;
    const Triangle film = is_solid(triangles[0], solid) ? triangles[1] : triangles[0];
    const auto ends = mesh.vertices(e);
    const auto& corners = mesh.vertices(film);
    const auto first = static_cast<std::size_t>(std::ranges::find(corners, ends[0]) - corners.begin());
    const bool forwards = (corners[(first + 1) % 3] == ends[1]) == (mesh.labels(film).q == lostopos::air);
    edges.push_back({mesh.position(ends[forwards ? 0 : 1]), mesh.position(ends[forwards ? 1 : 0])});
  }
  return edges;
}

// Ψ at x, L³/T: the velocity is its curl.
Vec3 potential(const VortexSources& sources, const Vec3& x, double delta) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t t = 0; t < sources.size(); ++t) {
    const Vec3 away = x - Vec3(sources.x[t], sources.y[t], sources.z[t]);
    sum += Vec3(sources.gx[t], sources.gy[t], sources.gz[t]) / std::sqrt(away.squaredNorm() + delta * delta);
  }
  return sum / (4 * std::numbers::pi);
}

// ∮ Ψ·dl, L³/T, by three points of Gauss on each edge.
double flux(const std::vector<RimEdge>& rim, const VortexSources& sources, double delta) {
  const double outer = std::sqrt(0.15);
  const std::array<std::pair<double, double>, 3> points{
      {{0.5 - outer, 5.0 / 18}, {0.5, 8.0 / 18}, {0.5 + outer, 5.0 / 18}}};
  double sum = 0;
  for (const auto& [start, end] : rim)
    for (const auto& [place, weight] : points)
      sum += weight * potential(sources, start + place * (end - start), delta).dot(end - start);
  return sum;
}

// Out of the bubble, L².
Vec3 area_of_film(const SurfaceMesh& mesh, Triangle t) {
  return (mesh.labels(t).q == lostopos::air ? 1 : -1) * lostopos::area_vector(mesh, t);
}

class RimGauge final : public Constraint {
 public:
  explicit RimGauge(RimFlow& flow) : flow_(flow) {}
  std::string_view name() const override { return "rim_gauge"; }
  void attach(lostopos::SurfaceTracker& /*tracker*/) override {}
  AirChange correct_circulation(const EffectStep& step, CirculationField& circulation, const SheetAir& air) override {
    std::vector<SheetTriangle> sheet;
    VortexSources sources;
    gather_sheet(step.mesh, circulation, sheet, step.solid);
    fill_vortex_sources(sheet, step.mesh.positions(), sources);
    flow_.through += step.dt * flux(rim(step.mesh, step.solid), sources, air.delta);
    add_corners(step, air);
    return {};
  }
  void prescribe(const Stage& /*stage*/, std::span<Vec3> /*positions*/) override {}

 private:
  void add_corners(const EffectStep& step, const SheetAir& air) {
    for (Triangle t : step.mesh.triangles()) {
      if (is_solid(t, step.solid)) continue;
      const Vec3 share = step.dt * area_of_film(step.mesh, t) / 3;
      for (lostopos::Vertex v : step.mesh.vertices(t)) {
        if (!step.is_held(v)) continue;
        Vec3 velocity;
        air.velocity({&v, 1}, {&velocity, 1});
        flow_.at_rim += share.dot(velocity);
        flow_.rim_share += share;
      }
    }
  }

  RimFlow& flow_;
};

}  // namespace

Scene gauged(const Scene& scene, RimFlow& flow) {
  auto catalogue = std::make_shared<Catalogue>(*scene.catalogue);
  catalogue->constraints.add({"rim_gauge", "what flows through a rim", {}, [&flow](const ConstraintSetup&) {
                                return std::make_unique<RimGauge>(flow);
                              }});
  Scene with_gauge = built_in_scene(scene.name, std::move(catalogue));
  for (const base::OptionSpec& spec : scene.options.specs())
    if (scene.options.is_set(spec.key)) with_gauge.options.set(spec.key, scene.options.value(spec.key), "test");
  std::vector<std::string> constraints = scene.options.words("constraints");
  constraints.emplace_back("rim_gauge");
  with_gauge.options.set("constraints", constraints, "test");
  return with_gauge;
}

Vec3 rim_area(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  Vec3 area = Vec3::Zero();
  for (const auto& [start, end] : rim(mesh, solid)) area += start.cross(end) / 2;
  return area;
}

}  // namespace foamsim::test
