#include "FoamSim/constraints/wire_air.h"

#include <Eigen/Geometry>

#include "FoamSim/sheet/velocity/direct.h"

namespace foamsim {

using lostopos::Vec3;
using lostopos::Vertex;

namespace {

std::vector<InductionTarget> targets_of(const EffectStep& step, std::span<const HeldFilm> films) {
  std::vector<InductionTarget> targets;
  for (const HeldFilm& film : films) targets.push_back({step.mesh.position(film.vertex), film.normal});
  return targets;
}

std::vector<Vec3> velocities_of(std::span<const HeldFilm> films, const SheetAir& air) {
  std::vector<Vertex> at;
  for (const HeldFilm& film : films) at.push_back(film.vertex);
  std::vector<Vec3> velocity(at.size(), Vec3::Zero());
  air.velocity(at, velocity);
  return velocity;
}

// How far the air leaves each film behind its target, along the normal.
Eigen::VectorXd missing(const EffectStep& step, std::span<const HeldFilm> films, std::span<const Vec3> velocity,
                        std::span<const Vec3> targets) {
  Eigen::VectorXd b(static_cast<Eigen::Index>(films.size()));
  for (std::size_t i = 0; i < films.size(); ++i) {
    const Vertex v = films[i].vertex;
    b[static_cast<Eigen::Index>(i)] =
        (targets[v.index()] - step.mesh.position(v) - step.dt * velocity[i]).dot(films[i].normal);
  }
  return b;
}

}  // namespace

AirChange WireAir::solve(const EffectStep& step, std::span<const std::uint8_t> wired, std::span<const Vec3> targets,
                         CirculationField& circulation, const SheetAir& air) {
  AirChange change;
  WireFilms films(step, wired);
  edges_.clear();
  delta_ = air.delta;
  if (options_.open_boundary && !films.open_edges.empty()) {
    edges_ = std::move(films.open_edges);
    const std::vector<Vec3> velocity = velocities_of(films.at_open_edges, air);
    const Induction induction(targets_of(step, films.at_open_edges), segment_sources(step.mesh.positions(), edges_),
                              edges_.size(), delta_, step.dt);
    Induction::Solution found =
        induction.solve(missing(step, films.at_open_edges, velocity, targets), options_.open_weight);
    strengths_ = std::move(found.x);
    change.iterations = found.iterations;
  }
  if (!options_.interior || films.inside.empty()) return change;
  std::vector<Vec3> velocity = velocities_of(films.inside, air);
  std::vector<Vec3> at(step.mesh.positions().size(), Vec3::Zero());
  add_velocity({step, step.time, step.mesh.positions()}, at);
  for (std::size_t i = 0; i < velocity.size(); ++i) velocity[i] += at[films.inside[i].vertex.index()];
  const Induction induction(targets_of(step, films.inside), film_sources(step, films.inside), films.inside.size(),
                            delta_, step.dt);
  const ClosedCirculation closed(step, films.inside);
  const Induction::Solution found =
      induction.solve(missing(step, films.inside, velocity, targets), options_.interior_weight,
                      [&closed](Eigen::VectorXd& change) { closed.project(change); });
  change.iterations = std::max(change.iterations, found.iterations);
  // K is a quadratic form of Γ, and −2 times the flux its derivative.
  const Eigen::VectorXd moved = induction.apply(found.x);
  for (std::size_t i = 0; i < films.inside.size(); ++i) {
    const HeldFilm& film = films.inside[i];
    const double more = found.x[static_cast<Eigen::Index>(i)];
    const lostopos::Labels pair{film.pair.low, film.pair.high};
    circulation.set(film.vertex, pair, circulation.get(film.vertex, pair) + more);
    const double faster = step.dt > 0 ? moved[static_cast<Eigen::Index>(i)] / step.dt : 0.0;
    change.work -= more * film.area * (2 * velocity[i].dot(film.normal) + faster);
  }
  return change;
}

std::vector<std::uint8_t> WireAir::takes_air(const EffectStep& step, std::span<const std::uint8_t> wired) const {
  const WireFilms films(step, wired);
  std::vector<std::uint8_t> takes(wired.size(), 0);
  if (options_.interior)
    for (const HeldFilm& film : films.inside) takes[film.vertex.index()] = 1;
  for (const HeldFilm& film : films.at_open_edges) takes[film.vertex.index()] = options_.open_boundary ? 1 : 0;
  return takes;
}

void WireAir::add_velocity(const Stage& stage, std::span<Vec3> velocity) const {
  if (edges_.empty()) return;
  VortexSources sources;
  sources.resize(edges_.size());
  const std::vector<InductionSource> segments = segment_sources(stage.positions, edges_);
  for (std::size_t k = 0; k < segments.size(); ++k)
    sources.set(k, segments[k].point, strengths_[static_cast<Eigen::Index>(k)] * segments[k].parts[0].strength);
  std::vector<Vec3> added(velocity.size());
  DirectBiotSavart().velocities(sources, stage.positions, delta_, added);
  for (std::size_t v = 0; v < velocity.size(); ++v) velocity[v] += added[v];
}

}  // namespace foamsim
