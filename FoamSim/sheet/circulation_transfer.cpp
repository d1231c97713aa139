#include "FoamSim/sheet/circulation_transfer.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"

namespace foamsim {

using lostopos::CollapseEvent;
using lostopos::Edge;
using lostopos::FlipEvent;
using lostopos::MergeEvent;
using lostopos::Place;
using lostopos::SeparationEvent;
using lostopos::SplitEvent;
using lostopos::SurfaceMesh;
using lostopos::Vertex;

void CirculationTransfer::touch(const SurfaceMesh& mesh, Vertex v) {
  touched_.push_back(v);
  for (Edge e : mesh.edges(v)) touched_.push_back(mesh.other_vertex(e, v));
}

void CirculationTransfer::match_touched(const SurfaceMesh& mesh) {
  base::sort_unique(touched_);
  std::erase_if(touched_, [&mesh](Vertex v) { return !mesh.alive(v); });
  match(values(), mesh, touched_);
  touched_.clear();
}

void CirculationTransfer::after_split(const SurfaceMesh& mesh, const SplitEvent& event) {
  value(event.added) = mean(values(), {{event.ends[0], event.ends[1]}, {0.5, 0.5}, 2});
  match(values(), mesh, std::span(&event.added, 1));
}

void CirculationTransfer::before_collapse(const SurfaceMesh& mesh, const CollapseEvent& event) {
  touched_.clear();
  touch(mesh, event.removed);
  carried_ = interpolate(value(event.kept), value(event.removed), event.t);
}

void CirculationTransfer::after_collapse(const SurfaceMesh& mesh, const CollapseEvent& event) {
  value(event.kept) = carried_;
  match_touched(mesh);
}

void CirculationTransfer::after_flip(const SurfaceMesh& mesh, const FlipEvent& event) {
  const std::array<Vertex, 4> corners{event.old_ends[0], event.old_ends[1], event.new_ends[0], event.new_ends[1]};
  match(values(), mesh, corners);
}

void CirculationTransfer::before_merge(const SurfaceMesh& mesh, const MergeEvent& event) {
  touched_.clear();
  for (const Place& place : event.places)
    for (std::size_t i = 0; i < place.count; ++i) touch(mesh, place.vertices[i]);
  carried_ = interpolate(mean(values(), event.places[0]), mean(values(), event.places[1]), event.t);
}

void CirculationTransfer::after_merge(const SurfaceMesh& mesh, const MergeEvent& event) {
  if (mesh.alive(event.result)) {
    value(event.result) = carried_;
    touch(mesh, event.result);
  }
  match_touched(mesh);
}

void CirculationTransfer::before_separation(const SurfaceMesh& mesh, const SeparationEvent& event) {
  touched_.clear();
  touch(mesh, event.vertex);
  carried_ = value(event.vertex);
}

void CirculationTransfer::after_separation(const SurfaceMesh& mesh, const SeparationEvent& event) {
  value(event.added) = carried_;
  const std::array<Vertex, 2> copies{event.vertex, event.added};
  match(values(), mesh, copies);  // a new film between the two may give them a pair, and then the neighbours
  for (Vertex copy : copies) carried_ = interpolate(carried_, value(copy), 0);
  touch(mesh, event.added);
  for (Vertex near : touched_)
    if (mesh.alive(near)) add_missing(values(), mesh, near, carried_);
  match_touched(mesh);
}

}  // namespace foamsim
