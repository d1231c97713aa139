// What it costs a step that the air goes with wires: the solves inside films, at open edges, and for fluxes.
#include <benchmark/benchmark.h>

#include <cmath>
#include <numbers>

#include "FoamSim/conservative/film_motion.h"
#include "FoamSim/conservative/held_flux.h"
#include "FoamSim/constraints/wire.h"
#include "FoamSim/sheet/sheet_velocity.h"
#include "FoamSim/sheet/velocity/registry.h"

namespace {

using foamsim::CirculationField;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

// A tube of nearly equilateral triangles about the x axis, of radius 1: five rings of n vertices.
SurfaceMesh tube(long n) {
  SurfaceMesh mesh;
  const double h = 2 * std::numbers::pi / static_cast<double>(n);
  std::vector<Vertex> vertices;
  for (long ring = -2; ring <= 2; ++ring)
    for (long i = 0; i < n; ++i) {
      const double angle = h * (static_cast<double>(i) + (ring % 2 == 0 ? 0.0 : 0.5));
      const double x = 0.866 * h * static_cast<double>(ring);
      vertices.push_back(mesh.add_vertex({x, std::cos(angle), std::sin(angle)}));
    }
  for (long ring = 0; ring < 4; ++ring)
    for (long i = 0; i < n; ++i) {
      const long next = (i + 1) % n;
      const Vertex a = vertices[ring * n + i], b = vertices[ring * n + next], c = vertices[(ring + 1) * n + i],
                   d = vertices[(ring + 1) * n + next];
      // The odd rings are half an edge ahead.
      const bool ahead = ring % 2 == 0;
      mesh.add_triangle(a, b, ahead ? c : d, {lostopos::Region(1), lostopos::Region(0)});
      mesh.add_triangle(ahead ? b : a, d, c, {lostopos::Region(1), lostopos::Region(0)});
    }
  return mesh;
}

// Of all wavelengths.
double rough(Vertex v) {
  const double i = v.index();
  return std::sin(0.1 * i * i);
}

struct Film {
  explicit Film(long n)
      : h(2 * std::numbers::pi / static_cast<double>(n)),
        tracker(tube(n), {.resolution = h}),
        circulation(tracker.mesh()) {
    geometry.update(tracker.mesh());
    for (Vertex v : tracker.mesh().vertices())
      for (auto& held : circulation.at(v)) held.value = rough(v);
  }
  double h;
  lostopos::SurfaceTracker tracker;
  CirculationField circulation;
  foamsim::SurfaceGeometry geometry;
};

void solve(benchmark::State& state, const char* wire, bool open) {
  Film film(state.range(0));
  const double dt = 0.9 * std::pow(film.h, 1.5), delta = 0.75 * film.h;
  foamsim::Wire constraint({foamsim::WireSpec(wire)},
                           {.interior = !open, .open_boundary = open, .interior_weight = 0.1 * film.h}, film.h, dt);
  constraint.attach(film.tracker);
  const foamsim::EffectStep step{film.tracker.mesh(), film.geometry, 0, dt, film.tracker.held().slots(), {}};
  foamsim::SheetVelocity velocity(foamsim::make_biot_savart("direct"));
  std::vector<foamsim::SheetTriangle> sheet;
  const foamsim::SheetAir air{delta, [&](std::span<const Vertex> at, std::span<Vec3> out) {
                                gather_sheet(film.tracker.mesh(), film.circulation, sheet);
                                std::vector<Vec3> targets;
                                for (Vertex v : at) targets.push_back(film.tracker.mesh().position(v));
                                velocity.evaluate(sheet, film.tracker.mesh().positions(), targets, delta, out);
                              }};
  long iterations = 0;
  for (auto _ : state) iterations = constraint.correct_circulation(step, film.circulation, air).iterations;
  state.counters["iterations"] = static_cast<double>(iterations);
}

void wire_inside(benchmark::State& state) {
  solve(state, "x > -0.0001 and x < 0.0001: move 1 0.5 0", false);
}

// Two rings: as many vertices as the argument says in all.
void wires_at_open_edges(benchmark::State& state) {
  solve(state, "free-edges: move 1 0.5 0", true);
}

void wire_flux(benchmark::State& state) {
  Film film(state.range(0));
  const double delta = 0.5 * film.h;
  std::vector<std::uint8_t> driven;
  std::vector<lostopos::Hold> held;
  for (Vertex v : film.tracker.mesh().vertices()) {
    driven.push_back(std::abs(film.tracker.mesh().position(v).x()) < 0.1 * film.h ? 1 : 0);
    held.push_back(driven.back() != 0 ? lostopos::Hold::all : lostopos::Hold::none);
  }
  foamsim::FilmConnectivity films;
  foamsim::FilmShape shape;
  films.update(film.tracker.mesh(), film.geometry, held, {});
  shape.update(films, film.tracker.mesh().positions());
  const foamsim::NearField near(delta, 0.2 * film.h * film.h);
  foamsim::HeldFlux flux(delta, near);
  const std::vector<double> no_flux(films.entries(), 0.0);
  std::vector<Vec3> velocity;
  for (Vertex v : film.tracker.mesh().vertices()) velocity.emplace_back(0, rough(v), 1);
  long iterations = 0;
  for (auto _ : state) {
    std::vector<double> phi(films.entries(), 0.0);
    flux.update(films, shape, film.tracker.mesh().positions(), driven);
    iterations = flux.solve(no_flux, velocity, phi);
  }
  state.counters["iterations"] = static_cast<double>(iterations);
}

BENCHMARK(wire_inside)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(wires_at_open_edges)
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK(wire_flux)->Arg(200)->Arg(2000)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();

}  // namespace

BENCHMARK_MAIN();
