#pragma once

#include <random>
#include <vector>

#include "FoamSim/conservative/film_motion.h"
#include "FoamSim/conservative/film_shape.h"
#include "FoamSim/dynamics/simulation.h"
#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim::test {

/// A mesh as the conservative scheme sees it, with positions that may be changed.
struct FilmSystem {
  explicit FilmSystem(const lostopos::SurfaceMesh& mesh) : x(mesh.positions().begin(), mesh.positions().end()) {
    SurfaceGeometry geometry;
    geometry.update(mesh);
    films.update(mesh, geometry, {}, {});
    shape.update(films, x);
  }

  /// With what the simulation holds.
  explicit FilmSystem(const Simulation& simulation)
      : x(simulation.mesh().positions().begin(), simulation.mesh().positions().end()) {
    films.update(simulation.mesh(), simulation.geometry(), simulation.held(), simulation.solid());
    shape.update(films, x);
  }

  /// Potentials between −1 and 1.
  std::vector<double> random_phi(unsigned seed = 1) const {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> value(-1, 1);
    std::vector<double> phi(films.entries());
    for (double& each : phi) each = value(random);
    return phi;
  }

  FilmMotion motion(const std::vector<double>& phi, double delta, double near_delta = 0) const {
    FilmMotion motion(delta, near_delta > 0 ? NearField(near_delta, 1e-3) : NearField());
    FilmShape now;
    now.update(films, x);
    motion.evaluate(films, now, x, phi, PairTerms::all);
    return motion;
  }

  FilmConnectivity films;
  FilmShape shape;
  std::vector<lostopos::Vec3> x;
};

}  // namespace foamsim::test
