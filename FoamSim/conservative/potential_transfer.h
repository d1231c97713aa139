#pragma once

#include <boost/container/small_vector.hpp>
#include <vector>

#include "FoamSim/conservative/potential.h"
#include "FoamSim/sheet/region_pair.h"

namespace foamsim {

/// Carries φ through the tracker's operations. A split takes the mean of the two ends; a collapse or merge the value
/// between the two places; a separation copies. Then, when `conserving` and where a vertex is left over (collapse,
/// merge, smoothing), its φ is changed so that ∫ Γ^{pq} dA over the triangles around is what it was, for every pair
/// (p, q) there, as nearly as Γ's old range allows; and where the patch's own kinetic energy ½ ΣΣ γ_s·γ_t/(4π ρ_st)
/// would be more than it was, φ goes on from there towards its least, as far as it takes. Without both a collapse at a
/// border can multiply the energy.
class PotentialTransfer final : public lostopos::CarryPolicy<lostopos::Vertex, VertexPotential> {
 public:
  explicit PotentialTransfer(bool conserving) : conserving_(conserving) {}

  void after_split(const lostopos::SurfaceMesh& mesh, const lostopos::SplitEvent& event) override;
  void before_collapse(const lostopos::SurfaceMesh& mesh, const lostopos::CollapseEvent& event) override;
  void after_collapse(const lostopos::SurfaceMesh& mesh, const lostopos::CollapseEvent& event) override;
  void after_flip(const lostopos::SurfaceMesh& mesh, const lostopos::FlipEvent& event) override;
  void before_move(const lostopos::SurfaceMesh& mesh, const lostopos::MoveEvent& event) override;
  void after_move(const lostopos::SurfaceMesh& mesh, const lostopos::MoveEvent& event) override;
  void before_merge(const lostopos::SurfaceMesh& mesh, const lostopos::MergeEvent& event) override;
  void after_merge(const lostopos::SurfaceMesh& mesh, const lostopos::MergeEvent& event) override;
  void before_separation(const lostopos::SurfaceMesh& mesh, const lostopos::SeparationEvent& event) override;
  void after_separation(const lostopos::SurfaceMesh& mesh, const lostopos::SeparationEvent& event) override;

 private:
  // Of one film in a patch of triangles.
  struct FilmSum {
    RegionPair pair;
    double integral = 0;       // ∫ Γ dA
    double low = 0, high = 0;  // range of Γ at its corners
  };

  VertexPotential mean(const lostopos::Place& place) const;
  void touch(const lostopos::SurfaceMesh& mesh, lostopos::Vertex v);
  // Every touched vertex that is left holds the regions that it has, no others.
  void match_touched(const lostopos::SurfaceMesh& mesh);
  void match(const lostopos::SurfaceMesh& mesh, lostopos::Vertex v);
  double jump(lostopos::Vertex v, RegionPair pair) const;
  // What the films of these triangles hold.
  void remember(const lostopos::SurfaceMesh& mesh, std::vector<lostopos::Triangle>& patch);
  // Chooses φ of v, the last vertex of the patch.
  void conserve(const lostopos::SurfaceMesh& mesh, lostopos::Vertex v);
  bool conserving_;
  VertexPotential carried_;
  std::vector<lostopos::Vertex> touched_;
  std::vector<lostopos::Triangle> patch_;
  boost::container::small_vector<FilmSum, 4> sums_;
};

}  // namespace foamsim
