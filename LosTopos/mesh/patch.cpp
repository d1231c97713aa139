#include "LosTopos/mesh/patch.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos::carry {
namespace {

class Patch {
 public:
  explicit Patch(const SurfaceMesh& mesh) : mesh_(mesh) {}
  void add_star(Vertex v) { add_triangles(mesh_.triangles(v)); }
  void add_triangles(std::span<const Triangle> triangles) {
    for (Triangle t : triangles) vertices_.insert(vertices_.end(), mesh_.vertices(t).begin(), mesh_.vertices(t).end());
  }
  std::vector<Vertex> sorted() {
    base::sort_unique(vertices_);
    return std::move(vertices_);
  }

 private:
  const SurfaceMesh& mesh_;
  std::vector<Vertex> vertices_;
};

}  // namespace

double vertex_area(const SurfaceMesh& mesh, Vertex v) {
  double sum = 0;
  for (Triangle t : mesh.triangles(v)) sum += area(mesh, t);
  return sum / 3;
}

std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const SplitEvent& event) {
  Patch patch(mesh);
  patch.add_triangles(mesh.triangles(event.edge));
  return patch.sorted();
}

std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const CollapseEvent& event) {
  Patch patch(mesh);
  patch.add_star(event.kept);
  patch.add_star(event.removed);
  return patch.sorted();
}

std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const FlipEvent& event) {
  Patch patch(mesh);
  patch.add_triangles(mesh.triangles(event.edge));
  if (event.moved.valid()) patch.add_star(event.moved);
  return patch.sorted();
}

std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const MoveEvent& event) {
  Patch patch(mesh);
  patch.add_star(event.vertex);
  return patch.sorted();
}

std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const MergeEvent& event) {
  Patch patch(mesh);
  for (const Place& place : event.places)
    for (std::size_t i = 0; i < place.count; ++i) patch.add_star(place.vertices[i]);
  return patch.sorted();
}

std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const SeparationEvent& event) {
  Patch patch(mesh);
  patch.add_star(event.vertex);
  return patch.sorted();
}

void keep_living(const SurfaceMesh& mesh, std::vector<Vertex>& patch, Vertex joined) {
  std::erase_if(patch, [&mesh](Vertex v) { return !mesh.alive(v); });
  if (joined.valid() && mesh.alive(joined) && !std::ranges::binary_search(patch, joined))
    patch.insert(std::ranges::lower_bound(patch, joined), joined);
}

Vertex heaviest_vertex(const Place& place) {
  const auto heaviest =
      std::max_element(place.weights.begin(), place.weights.begin() + static_cast<std::ptrdiff_t>(place.count));
  return place.vertices[static_cast<std::size_t>(heaviest - place.weights.begin())];
}

void EdgeOrigins::note(const SurfaceMesh& mesh, Vertex v) {
  for (Edge e : mesh.edges(v)) known_.push_back({mesh.other_vertex(e, v), e});
}

// The edges at v that were not there before go on from the first noted one to the same other end.
std::span<const EdgeSource> EdgeOrigins::made_at(const SurfaceMesh& mesh, Vertex v) {
  sources_.clear();
  if (!mesh.alive(v)) return sources_;
  for (Edge e : mesh.edges(v)) {
    if (std::ranges::find(known_, e, &Known::edge) != known_.end()) continue;
    const auto from = std::ranges::find(known_, mesh.other_vertex(e, v), &Known::other);
    if (from != known_.end()) sources_.push_back({e, from->edge});
  }
  return sources_;
}

void EdgeOrigins::before(const SurfaceMesh&, const SplitEvent& event) {
  known_ = {{event.ends[0], event.edge}, {event.ends[1], event.edge}};
}

std::span<const EdgeSource> EdgeOrigins::after(const SurfaceMesh& mesh, const SplitEvent& event) {
  return made_at(mesh, event.added);
}

void EdgeOrigins::before(const SurfaceMesh& mesh, const CollapseEvent& event) {
  known_.clear();
  note(mesh, event.kept);
  note(mesh, event.removed);
}

std::span<const EdgeSource> EdgeOrigins::after(const SurfaceMesh& mesh, const CollapseEvent& event) {
  return made_at(mesh, event.kept);
}

void EdgeOrigins::before(const SurfaceMesh& mesh, const MergeEvent& event) {
  known_.clear();
  for (const Place& place : event.places) {
    if (place.count == 1) note(mesh, place.vertices[0]);
    if (place.count != 2) continue;  // from within a triangle all edges are new
    const Edge split = mesh.find_edge(place.vertices[0], place.vertices[1]);
    known_.push_back({place.vertices[0], split});
    known_.push_back({place.vertices[1], split});
  }
}

std::span<const EdgeSource> EdgeOrigins::after(const SurfaceMesh& mesh, const MergeEvent& event) {
  return made_at(mesh, event.result);
}

void EdgeOrigins::before(const SurfaceMesh& mesh, const SeparationEvent& event) {
  known_.clear();
  note(mesh, event.vertex);
}

std::span<const EdgeSource> EdgeOrigins::after(const SurfaceMesh& mesh, const SeparationEvent& event) {
  return made_at(mesh, event.added);
}

}  // namespace lostopos::carry
