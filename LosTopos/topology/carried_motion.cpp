#include "LosTopos/topology/carried_motion.h"

#include <algorithm>

namespace lostopos {

double CarriedMotion::set(const SurfaceMesh& mesh, std::span<const Vec3> predicted) {
  double longest = 0;
  for (Vertex v : mesh.vertices()) {
    motion_[v] = predicted[v.index()] - mesh.position(v);
    longest = std::max(longest, motion_[v].squaredNorm());
  }
  return std::sqrt(longest);
}

Vec3 CarriedMotion::at(const Place& place) const {
  Vec3 mean = Vec3::Zero();
  for (std::size_t i = 0; i < place.count; ++i) mean += place.weights[i] * motion_[place.vertices[i]];
  return mean;
}

void CarriedMotion::after_split(const SurfaceMesh&, const SplitEvent& event) {
  motion_[event.added] = 0.5 * (motion_[event.ends[0]] + motion_[event.ends[1]]);
}

void CarriedMotion::before_collapse(const SurfaceMesh&, const CollapseEvent& event) {
  motion_[event.kept] = (1 - event.t) * motion_[event.kept] + event.t * motion_[event.removed];
}

void CarriedMotion::after_merge(const SurfaceMesh&, const MergeEvent& event) {
  motion_[event.result] = (1 - event.t) * at(event.places[0]) + event.t * at(event.places[1]);
}

void CarriedMotion::after_separation(const SurfaceMesh&, const SeparationEvent& event) {
  motion_[event.added] = motion_[event.vertex];
}

}  // namespace lostopos
