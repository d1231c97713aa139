#pragma once

#include <span>
#include <vector>

#include "FoamSim/conservative/local_response.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace foamsim {

/// Dissipation in the films from a Rayleigh function R = ½ η Σ_e w_e |u_i − u_j|², w_e = n_e / (2√3) for an edge with
/// n_e triangles: on regular triangles ½ η ∫ |∇u|² dA. Its force ∂R/∂u takes 2R of energy in a unit of time, whatever
/// the mesh; shear and dilation are damped alike.
class Viscosity {
 public:
  /// `coefficient`: η, surface viscosity over air density, L³/T, ≥ 0.
  explicit Viscosity(double coefficient) : coefficient_(coefficient) {}

  bool acts() const { return coefficient_ > 0; }
  /// The edges of films, to be called after the mesh has changed.
  void connect(const lostopos::SurfaceMesh& mesh, std::span<const std::uint8_t> solid);

  /// Adds the force (L⁴/T²) of a step dt (T) from velocities u (L/T, by vertex slot). It is that of the velocities at
  /// the step's end, as far as the local response tells them: linearly implicit, so that short waves are damped
  /// soundly however strong it is. (Waves as long as the bubbles ask for η dt below about four of their radii.) A
  /// system of two Laplacians is solved by conjugate gradients to nine digits. Returns how many iterations that took;
  /// after `most_iterations` the force is one of less implicit a step.
  int add_force(LocalResponse& response, double dt, std::span<const lostopos::Vec3> velocity,
                std::span<lostopos::Vec3> force) const;
  static constexpr int most_iterations = 60;

 private:
  using Vectors = std::vector<lostopos::Vec3>;
  struct Neighbour {
    std::uint32_t vertex;
    double weight;
  };
  void laplacian(std::span<const lostopos::Vec3> u, Vectors& out) const;

  double coefficient_;
  std::vector<std::uint32_t> first_;  // by vertex slot + 1
  std::vector<Neighbour> neighbours_;
};

}  // namespace foamsim
