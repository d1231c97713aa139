#pragma once

#include <span>
#include <vector>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// The straight motions of all vertices over a step while it is being made safe: where they start, where they are asked
/// to go, and where they end for now. Every vertex has mass 1, but infinite mass along coordinates that are held.
class Motion {
 public:
  /// `predicted` and `held` (see mesh/hold.h) are indexed by vertex handle; an empty `held` holds none. The spans must
  /// outlive this.
  Motion(const SurfaceMesh& mesh, std::span<const Vec3> predicted, std::span<const Hold> held);

  /// All vertices are asked to go, and end, at start + fraction (predicted - start).
  void restart(double fraction);

  std::span<const Vec3> starts() const { return starts_; }
  std::span<const Vec3> ends() const { return ends_; }
  Vec3 displacement(Vertex v) const { return ends_[v.index()] - starts_[v.index()]; }
  /// Where v is asked to go (L).
  Vec3 asked(Vertex v) const;
  Hold hold(Vertex v) const { return held_.empty() ? Hold::none : held_[v.index()]; }
  /// Held in all coordinates.
  bool held(Vertex v) const { return is_held(hold(v)); }
  double inverse_mass(Vertex v) const { return held(v) ? 0 : 1; }
  /// How far a unit impulse along a unit vector moves v along it.
  double mobility(Vertex v, const Vec3& direction) const;

  /// Lets v end at x, but with its held coordinates where they are asked to go, and notes the change.
  void set_end(Vertex v, const Vec3& x);
  /// Asks for v's contacts to be looked at again.
  void note_changed(Vertex v) {
    if (!is_changed_[v.index()]) changed_.push_back(v);
    is_changed_[v.index()] = 1;
  }
  std::span<const Vertex> changed() const { return changed_; }
  bool is_changed(Vertex v) const { return is_changed_[v.index()] != 0; }
  void forget_changes();

 private:
  std::span<const Vec3> starts_, predicted_;
  std::span<const Hold> held_;
  double fraction_ = 1;
  std::vector<Vec3> ends_;
  std::vector<char> is_changed_;
  std::vector<Vertex> changed_;
};

}  // namespace lostopos
