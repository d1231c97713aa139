#pragma once

#include <span>
#include <vector>

#include "FoamSim/conservative/film_shape.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Dissipation in the films from a Rayleigh function R = ½ η Σ_e w_e |u_i − u_j|², w_e = n_e / (2√3) for an edge with
/// n_e triangles: on regular triangles ½ η ∫ |∇u|² dA. Its force ∂R/∂u takes 2R of energy in a unit of time, whatever
/// the mesh; shear and dilation are damped alike.
class Viscosity {
 public:
  /// `coefficient`: η, surface viscosity over air density, L³/T, ≥ 0. `resolution`: h̄, L.
  Viscosity(double coefficient, double resolution) : coefficient_(coefficient), resolution_(resolution) {}

  bool acts() const { return coefficient_ > 0; }
  /// The edges of films, to be called after the mesh has changed.
  void connect(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid);

  /// Adds the force (L⁴/T²) of a step dt (T) from velocities u (L/T, by vertex slot). It is that of the velocities at
  /// the step's end, as far as a local stand-in for the air's response tells them: linearly implicit, so that no step
  /// is too long for it. A system of two Laplacians is solved by conjugate gradients, 60 iterations at most; fewer make
  /// the force one of less implicit a step.
  void add_force(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                 double dt, std::span<const lostopos::Vec3> velocity, std::span<lostopos::Vec3> force);

 private:
  using Vectors = std::vector<lostopos::Vec3>;
  struct Neighbour {
    std::uint32_t vertex;
    double weight;
  };
  void laplacian(std::span<const lostopos::Vec3> u, Vectors& out) const;
  // What a force does to the velocities in a unit of time by the air around the vertex alone.
  void response(const FilmConnectivity& films, const FilmShape& shape, std::span<const lostopos::Vec3> positions,
                std::span<const lostopos::Vec3> force, Vectors& velocity);

  double coefficient_, resolution_;
  std::vector<std::uint32_t> first_;  // by vertex slot + 1
  std::vector<Neighbour> neighbours_;
  std::vector<double> pressure_, flux_;
  Vectors potential_;
};

}  // namespace foamsim
