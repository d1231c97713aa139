// Wires in the conservative dynamics: the flux at what they hold is theirs, and their work is all that changes energy.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "FoamSim/conservative/film_motion.h"
#include "FoamSim/conservative/held_flux.h"
#include "FoamSim/conservative/potential.h"
#include "FoamSim/scenes/scene.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::Vec3;
using lostopos::Vertex;

Scene conservative(const char* name, const std::vector<std::string>& assignments) {
  Scene scene = built_in_scene(name);
  scene.options.set_assignment("dynamics=conservative", "test");
  for (const std::string& assignment : assignments) scene.options.set_assignment(assignment, "test");
  return scene;
}

// A ball with a belt that is driven, and some motion of the air.
TEST(HeldFlux, IsThatOfTheWire) {
  const double delta = 0.15;
  const auto mesh = lostopos::test::globe(1, 7);
  SurfaceGeometry geometry;
  geometry.update(mesh);
  std::vector<std::uint8_t> driven(mesh.vertex_slots(), 0);
  std::vector<lostopos::Hold> held(mesh.vertex_slots(), lostopos::Hold::none);
  for (Vertex v : mesh.vertices())
    if (std::abs(mesh.position(v).x()) < 0.3) {
      driven[v.index()] = 1;
      held[v.index()] = lostopos::Hold::all;
    }
  FilmConnectivity films;
  FilmShape shape;
  films.update(mesh, geometry, held, {});
  shape.update(films, mesh.positions());
  const NearField near(delta, 0.01);
  FilmMotion motion(delta, near);
  std::vector<double> phi(films.entries());
  for (std::size_t e = 0; e < phi.size(); ++e) phi[e] = std::sin(0.7 * static_cast<double>(e));
  const std::vector<double> before = phi;
  motion.evaluate(films, shape, mesh.positions(), phi, PairTerms::potential);
  const std::vector<Vec3> velocity(mesh.vertex_slots(), Vec3(0.3, -0.2, 0.5));
  HeldFlux flux(delta, near);
  flux.update(films, shape, mesh.positions(), driven);
  const long iterations = flux.solve(motion.flux(), velocity, phi);
  EXPECT_LT(iterations, HeldFlux::most_iterations);
  motion.evaluate(films, shape, mesh.positions(), phi, PairTerms::potential);
  double largest = 0;
  for (const Vec3& a : shape.region_gradient) largest = std::max(largest, a.norm());
  for (std::size_t v = 0; v < films.vertex_slots(); ++v)
    for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e) {
      if (driven[v] != 0)
        EXPECT_NEAR(motion.flux()[e], shape.region_gradient[e].dot(velocity[v]), 1e-6 * largest);
      else
        EXPECT_EQ(phi[e], before[e]);
    }
}

struct Balance {
  double before = 0, after = 0, work = 0, remeshing = 0;
  /// Of the energy, what neither wires nor the tracker's operations on the mesh account for.
  double error() const { return (after - before - work - remeshing) / after; }
};

// From rest. Energies are those at the start of each step, works those during it.
Balance balance(Simulation& simulation, int steps) {
  Balance b;
  double work = 0;
  for (int i = 0; i <= steps; ++i) {
    const StepReport report = simulation.step();
    b.work += work;
    work = report.wire_work;
    b.after = report.kinetic_energy + report.potential_energy;
    if (i == 0) b.before = report.potential_energy;
    b.remeshing += report.tracker_kinetic_energy + report.tracker_surface_energy;
    EXPECT_LT(report.wire_iterations, HeldFlux::most_iterations);
  }
  return b;
}

// The other steppings find the potentials at every stage.
TEST(ConservativeWire, WorkIsCountedWithRungeKutta) {
  Simulation simulation =
      make_simulation(conservative("bubblewand", {"constraints=wire", "wires=held: move -2 0 0", "stepping=rk4",
                                                  "open_boundary=true", "remeshing.enabled=false", "dt=0.004"}));
  const Balance b = balance(simulation, 25);
  EXPECT_GT(b.work, 0.5);
  EXPECT_LT(std::abs(b.error()), 0.005);
}

// A frame holds vertices and lets the air by: a wire that stands still does not.
TEST(ConservativeWire, StopsTheAirWhereAFrameDoesNot) {
  const auto largest_flux = [](const char* constraint) {
    Scene scene = conservative("constrainedsphere", {std::string("constraints=") + constraint});
    Simulation simulation = make_simulation(scene);
    for (int i = 0; i < 5; ++i) simulation.step();
    FilmConnectivity films;
    FilmShape shape;
    films.update(simulation.mesh(), simulation.geometry(), simulation.held(), simulation.solid());
    shape.update(films, simulation.mesh().positions());
    std::vector<double> phi(films.entries(), 0.0);
    take_circulation(films, simulation.circulation(), phi);
    FilmMotion motion(simulation.delta(), NearField(simulation.delta(), 1e-3));
    motion.evaluate(films, shape, simulation.mesh().positions(), phi, PairTerms::potential);
    double at_wire = 0, anywhere = 0;
    for (std::size_t v = 0; v < films.vertex_slots(); ++v)
      for (std::size_t e = films.first_entry[v]; e < films.first_entry[v + 1]; ++e) {
        anywhere = std::max(anywhere, std::abs(motion.flux()[e]));
        if (films.held[v] != 0) at_wire = std::max(at_wire, std::abs(motion.flux()[e]));
      }
    return at_wire / anywhere;
  };
  EXPECT_GT(largest_flux("frame"), 0.2);
  EXPECT_LT(largest_flux("wire"), 0.05);
}

TEST(ConservativeWire, WorkIsWhatChangesTheEnergyOfPulledRings) {
  Simulation simulation =
      make_simulation(conservative("tworingspinching", {"constraints=wire", "wires=held: pull 0.08"}));
  const Balance b = balance(simulation, 40);
  EXPECT_GT(b.work, 0.5);
  EXPECT_LT(std::abs(b.error()), 0.005);
}

// Air goes round a wire at which a film ends: a tube between two of them contracts. (With its flux prescribed there it
// could not: the same jump of the potential all over the tube moves nothing.)
TEST(ConservativeWire, LetsATubeContract) {
  Simulation simulation = make_simulation(conservative("tworingspinching", {"constraints=wire", "wires=held: still"}));
  const double before = simulation.geometry().total_area();
  StepReport last;
  double least = before;
  for (int i = 0; i < 26; ++i) {
    last = simulation.step();
    least = std::min(least, simulation.geometry().total_area());
  }
  EXPECT_LT(least, 0.99 * before);
  EXPECT_EQ(last.wire_iterations, 0);
  EXPECT_EQ(last.wire_work, 0);
}

TEST(ConservativeWire, KeepsTheEnergyOfAHeldSphere) {
  Simulation simulation = make_simulation(conservative("constrainedsphere", {"constraints=wire"}));
  const Balance b = balance(simulation, 10);
  EXPECT_EQ(b.work, 0);
  EXPECT_LT(std::abs(b.error()), 0.001);
}

TEST(ConservativeWire, WorkIsWhatChangesTheEnergyOfAWand) {
  Simulation simulation = make_simulation(conservative("bubblewand", {"constraints=wire", "wires=held: move -2 0 0"}));
  const Balance b = balance(simulation, 20);
  EXPECT_GT(b.work, 1);
  EXPECT_LT(std::abs(b.error()), 0.005);
}

// Ten steps of a wand that is dragged (held flux, its solver) and of a sheet with a rod.
TEST(ConservativeConstraints, HaveTheSameBitsForAnyNumberOfThreads) {
  const auto run = [](const Scene& scene, std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    Simulation simulation = make_simulation(scene);
    for (int i = 0; i < 10; ++i) simulation.step();
    return nlohmann::json::to_cbor(to_json(simulation.state()));
  };
  for (const Scene& scene :
       {conservative("bubblewand", {"constraints=wire", "wires=held: move -2 0 0"}), conservative("sheet", {})}) {
    const auto one = run(scene, 1);
    EXPECT_EQ(run(scene, 2), one) << scene.name;
    EXPECT_EQ(run(scene, 5), one) << scene.name;
  }
}

}  // namespace
}  // namespace foamsim
