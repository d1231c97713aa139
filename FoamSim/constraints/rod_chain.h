#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <span>
#include <vector>

#include "LosTopos/vec3.h"

namespace foamsim {

/// What an elastic rod is made of, in units of its own (SI, say).
struct RodMaterial {
  double radius = 5e-5;      ///< r
  double density = 1320;     ///< ρ, mass over volume
  double stretching = 5000;  ///< k, spring constant of a segment, whatever its length
  double bending = 250;      ///< α
  double damping = 1;        ///< d of the drag that comes with bending
  double gravity = 0;        ///< g, along −z
};

/// How the rod's step is made.
enum class RodScheme {
  implicit,  ///< linearised implicit Euler
  reference  ///< that of the reference program, where dt H v counts twice, which damps stiff modes more
};

/// A triangle of film at vertex `vertex` of a rod; its other two corners stay where they are.
struct RodFilm {
  std::uint32_t vertex;
  lostopos::Vec3 b, c;
};

/// An elastic rod as a chain of vertices, open or closed: stretching ½ k (|x_{i+1} − x_i| − l_i)², bending ½ α |(c1 +
/// c2) x_i − c1 x_{i−1} − c2 x_{i+1}|² with c1 = (a + b)/2a, c2 = (a + b)/2b for rest lengths a, b on both sides
/// (straight at rest), weight, and the pull of films, pull × area (docs/method.md "Wires").
class RodChain {
 public:
  using Points = std::vector<lostopos::Vec3>;

  /// `lengths`: at rest, l_i from vertex i to i + 1 (L, > 0); as many as vertices where the chain is closed, else one
  /// less. `fixed`: by vertex, not zero where it does not move.
  RodChain(std::vector<double> lengths, bool closed, std::vector<char> fixed, const RodMaterial& material);

  std::size_t size() const { return fixed_.size(); }
  const std::vector<double>& lengths() const { return lengths_; }
  /// Mass of vertex i: π r² ρ times half of the lengths at it.
  double mass(std::size_t i) const { return mass_[i]; }

  /// Of the rod itself and of films that pull with `pull` (force over length).
  double energy(std::span<const lostopos::Vec3> x, double pull, std::span<const RodFilm> films) const;
  Eigen::VectorXd gradient(std::span<const lostopos::Vec3> x, double pull, std::span<const RodFilm> films) const;
  /// Second derivatives, those of the films of each vertex by itself. `positive`: without what makes segments under
  /// pressure unstable.
  Eigen::SparseMatrix<double> hessian(std::span<const lostopos::Vec3> x, double pull, std::span<const RodFilm> films,
                                      bool positive = false) const;

  /// A step dt > 0 of positions and velocities: (M + dt D + dt² H) Δv = dt (−∇E(x) − dt H v − D v), D the drag, H
  /// positive, by a sparse factorisation. The reference scheme has the gradient at x + dt v instead, and H as it is.
  void advance(double dt, RodScheme scheme, double pull, std::span<const RodFilm> films, Points& x, Points& v) const;

 private:
  // Vertices before and behind i, where there are both, and the factors of the bending there.
  struct Bend {
    std::size_t before, at, behind;
    double c1, c2;
  };
  std::size_t after(std::size_t i) const { return i + 1 < size() ? i + 1 : 0; }

  std::vector<double> lengths_;
  std::vector<char> fixed_;
  RodMaterial material_;
  std::vector<Bend> bends_;
  std::vector<double> mass_, drag_;
};

}  // namespace foamsim
