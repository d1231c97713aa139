#pragma once

#include <span>
#include <vector>

#include "FoamSim/constraints/induction.h"
#include "FoamSim/effects/effect_step.h"
#include "FoamSim/sheet/region_pair.h"

namespace foamsim {

/// A film at a held vertex, and the direction in which the air has to go with the vertex there.
struct HeldFilm {
  lostopos::Vertex vertex;
  RegionPair pair;
  lostopos::Vec3 normal;  ///< mean of the film's triangles there, out of pair.low, of length 1
  double area = 0;        ///< a third of the film's triangles at the vertex, projected on the normal; L²
};

/// An edge with two held ends where films end in the air or at a solid: where the films' triangles around it close no
/// region off. `from` and `to` are in the sense of its first film triangle, seen with the lower region behind.
struct OpenEdge {
  lostopos::Vertex from, to;
  std::vector<lostopos::Triangle> films;
};

/// Where wires hold films (docs/method.md "Wires"): along open edges, or in the middle of films, which there
/// go on to both sides.
struct WireFilms {
  std::vector<OpenEdge> open_edges;
  std::vector<HeldFilm> at_open_edges;  ///< of every vertex of such an edge, each film that ends there
  std::vector<HeldFilm> inside;         ///< all others, those of a vertex one behind the other

  /// `wired`: by vertex slot, not zero for those that the wires hold. Solid triangles are no films.
  WireFilms(const EffectStep& step, std::span<const std::uint8_t> wired);
};

/// How Γ at films may change together. Where several meet at a vertex the potential is one number a region, and the
/// changes of its jumps add up to nothing round every Plateau border: ΔΓ^{pq} = φ^p − φ^q.
class ClosedCirculation {
 public:
  /// Of changes at `films`, those of a vertex one behind the other; at other films of their vertices Γ stays.
  ClosedCirculation(const EffectStep& step, std::span<const HeldFilm> films);
  /// Makes of changes, one a film, those of such potentials that are nearest to them.
  void project(Eigen::VectorXd& change) const;

 private:
  struct Block {
    Eigen::Index first;
    Eigen::MatrixXd projection;
  };
  std::vector<Block> blocks_;  // of vertices where not all changes are free
};

/// The vorticity that circulation at `films`, one unknown each, gives to the triangles around them.
std::vector<InductionSource> film_sources(const EffectStep& step, std::span<const HeldFilm> films);
/// Straight vortices of unit strength along open edges: in their middle, one unknown each.
std::vector<InductionSource> segment_sources(std::span<const lostopos::Vec3> positions,
                                             std::span<const OpenEdge> edges);

}  // namespace foamsim
