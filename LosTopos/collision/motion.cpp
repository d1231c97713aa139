#include "LosTopos/collision/motion.h"

namespace lostopos {

Motion::Motion(const SurfaceMesh& mesh, std::span<const Vec3> predicted, std::span<const Hold> held)
    : starts_(mesh.positions()),
      predicted_(predicted),
      held_(held),
      ends_(predicted.begin(), predicted.end()),
      is_changed_(mesh.vertex_slots(), 0) {}

void Motion::restart(double fraction) {
  fraction_ = fraction;
  for (std::size_t i = 0; i < ends_.size(); ++i) ends_[i] = asked(Vertex(i));
  forget_changes();
}

Vec3 Motion::asked(Vertex v) const {
  // At fraction 1 to the bit, and without overflow for motions from one end of the doubles to the other.
  if (fraction_ == 1) return predicted_[v.index()];
  return (1 - fraction_) * starts_[v.index()] + fraction_ * predicted_[v.index()];
}

double Motion::mobility(Vertex v, const Vec3& direction) const {
  return hold(v) == Hold::none ? 1 : free_part(hold(v), direction).squaredNorm();
}

void Motion::set_end(Vertex v, const Vec3& x) {
  ends_[v.index()] = x;
  if (const Hold hold_of_v = hold(v); hold_of_v != Hold::none) {
    const Vec3 prescribed = asked(v);
    for (int i = 0; i < 3; ++i)
      if (holds(hold_of_v, i)) ends_[v.index()][i] = prescribed[i];
  }
  note_changed(v);
}

void Motion::forget_changes() {
  for (Vertex v : changed_) is_changed_[v.index()] = 0;
  changed_.clear();
}

}  // namespace lostopos
