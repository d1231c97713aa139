#include "LosTopos/collision/near_triangles.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"
#include "Base/parallel/for_each.h"
#include "LosTopos/collision/box_overlap.h"
#include "LosTopos/collision/triangle_gap.h"

namespace lostopos {
namespace {

// A vertex on its way is placed ahead, so that it stays within the slack for some steps of the same length: by this
// many of its displacements, and not so far that a way back would leave the slack at once.
constexpr double displacements_ahead = 2;
constexpr double most_ahead = 0.9;  // over the slack
// Against rounding: gaps are looked for that are larger than needed by this share.
constexpr double rounding_share = 1e-6;
// When more than this share of the triangles has changed, the boxes are built anew.
constexpr double most_changed = 0.2;

Vec3 place_ahead(const Vec3& from, const Vec3& to, double slack) {
  const Vec3 way = to - from;
  const double length = way.norm();
  if (!(length > 0)) return from;
  const double ahead = std::max(std::min(displacements_ahead * length, most_ahead * slack), length - slack);
  return from + ahead / length * way;
}

// So many triangles may wait for their lists while others are asked for theirs.
constexpr std::size_t most_stale = 500;

constexpr std::array<Vertex, 3> no_corners = {};

}  // namespace

bool NearTriangles::move_places(const SurfaceMesh& mesh, std::span<const Vec3> from, std::span<const Vec3> to) {
  bool covered = true;
  places_.resize(mesh.vertex_slots(), Vec3::Zero());
  is_moved_.assign(mesh.vertex_slots(), 0);
  for (Vertex v : mesh.vertices()) {
    Vec3& place = places_[v.index()];
    const Vec3 &start = from[v.index()], &end = to[v.index()];
    if (holds(place, start) && holds(place, end)) continue;
    Vec3 next = place_ahead(start, end, margins_.slack);
    if (!holds(next, start) || !holds(next, end)) {
      covered = false;
      if (holds(place, start)) continue;
      next = start;
    }
    place = next;
    is_moved_[v.index()] = 1;
  }
  return covered;
}

bool NearTriangles::follow(const SurfaceMesh& mesh, std::span<const Vec3> from, std::span<const Vec3> to) {
  const bool covered = move_places(mesh, from, to);
  const std::size_t slots = std::max(corners_.size(), mesh.triangle_slots());
  corners_.resize(slots, no_corners);
  near_.resize(slots);
  is_stale_.resize(slots, 0);
  std::vector<Triangle> different;
  for (Triangle t(0); t.index() < slots; t = Triangle(t.index() + std::size_t{1})) {
    if (t.index() >= mesh.triangle_slots() || !mesh.alive(t)) {
      removed(t);
      continue;
    }
    const auto& [a, b, c] = mesh.vertices(t);
    if (corners_[t.index()] != mesh.vertices(t) || is_moved_[a.index()] || is_moved_[b.index()] || is_moved_[c.index()])
      different.push_back(t);
  }
  if (static_cast<double>(different.size()) > most_changed * static_cast<double>(mesh.triangle_count())) {
    boxes_.build(mesh, places_, places_, margins_.slack);
    for (Triangle t : different) {
      corners_[t.index()] = mesh.vertices(t);
      note_stale(t);
    }
  } else {
    for (Triangle t : different) take_in(mesh, t);
  }
  return covered;
}

void NearTriangles::take_in(const SurfaceMesh& mesh, Triangle t) {
  corners_[t.index()] = mesh.vertices(t);
  boxes_.set(t, triangle_box(mesh, t, places_, margins_.slack));
  note_stale(t);
}

void NearTriangles::note_stale(Triangle t) {
  if (!is_stale_[t.index()]) stale_.push_back(t);
  is_stale_[t.index()] = 1;
}

void NearTriangles::changed(const SurfaceMesh& mesh, Triangle t) {
  if (t.index() >= corners_.size()) {
    corners_.resize(mesh.triangle_slots(), no_corners);
    near_.resize(mesh.triangle_slots());
    is_stale_.resize(mesh.triangle_slots(), 0);
  }
  places_.resize(mesh.vertex_slots(), Vec3::Zero());
  for (Vertex v : mesh.vertices(t)) {
    if (covers(v, mesh.position(v))) continue;
    places_[v.index()] = mesh.position(v);
    for (Triangle u : mesh.triangles(v))
      if (u != t && u.index() < corners_.size() && corners_[u.index()] == mesh.vertices(u)) take_in(mesh, u);
    corners_[t.index()] = no_corners;
  }
  if (corners_[t.index()] != mesh.vertices(t)) take_in(mesh, t);
}

void NearTriangles::removed(Triangle t) {
  if (corners_[t.index()] == no_corners) return;
  forget_neighbours(t);
  boxes_.remove(t);
  corners_[t.index()] = no_corners;
}

void NearTriangles::forget_neighbours(Triangle t) {
  for (Triangle u : near_[t.index()]) {
    List& of_neighbour = near_[u.index()];
    of_neighbour.erase(std::ranges::find(of_neighbour, t));
  }
  near_[t.index()].clear();
}

bool NearTriangles::append_around(const SurfaceMesh& mesh, Vertex v, std::vector<Triangle>& found) {
  // A search in place of the lists costs about as much as a list that waits: these are made when as many have asked.
  if (stale_.size() > most_stale) {
    if (++turned_away_ < stale_.size()) return false;
    complete(mesh);
  }
  Box around = boxes_.box(mesh.triangles(v)[0]);
  for (Triangle t : mesh.triangles(v)) {
    if (is_stale_[t.index()]) return false;
    around = {around.low.cwiseMin(boxes_.box(t).low), around.high.cwiseMax(boxes_.box(t).high)};
    found.insert(found.end(), near_[t.index()].begin(), near_[t.index()].end());
  }
  around.low.array() -= margins_.reach;
  around.high.array() += margins_.reach;
  for (Triangle t : stale_)
    if (corners_[t.index()] != no_corners && overlap(boxes_.box(t), around)) found.push_back(t);
  return true;
}

void NearTriangles::complete(const SurfaceMesh& mesh) {
  turned_away_ = 0;
  if (stale_.empty()) return;
  std::erase_if(stale_, [this](Triangle t) {
    const bool gone = corners_[t.index()] == no_corners;
    if (gone) is_stale_[t.index()] = 0;
    return gone;
  });
  for (Triangle t : stale_) forget_neighbours(t);
  std::vector<List> found(stale_.size());
  constexpr std::size_t grain = 64;
  base::parallel_ranges(0, stale_.size(), grain, [&](std::size_t begin, std::size_t end) {
    std::vector<Triangle> candidates;
    for (std::size_t i = begin; i != end; ++i) search(mesh, stale_[i], candidates, found[i]);
  });
  for (std::size_t i = 0; i < stale_.size(); ++i) {
    for (Triangle u : found[i]) {
      near_[stale_[i].index()].push_back(u);
      near_[u.index()].push_back(stale_[i]);
    }
    is_stale_[stale_[i].index()] = 0;
  }
  stale_.clear();
}

// Of two stale triangles the smaller looks for the other.
void NearTriangles::search(const SurfaceMesh& mesh, Triangle t, std::vector<Triangle>& candidates, List& found) const {
  candidates.clear();
  Box box = boxes_.box(t);
  box.low.array() -= margins_.reach;
  box.high.array() += margins_.reach;
  boxes_.query_unsorted(box, candidates);
  const double distance = (margins_.reach + 2 * margins_.slack) * (1 + rounding_share);
  const PlacedTriangle placed = placed_triangle(mesh, t, places_);
  for (Triangle u : candidates) {
    if (u == t || (is_stale_[u.index()] && u < t) || is_beyond(placed, mesh, u, places_, distance)) continue;
    if (!have_near_elements(placed, placed_triangle(mesh, u, places_), distance)) continue;
    if (std::ranges::find(found, u) == found.end()) found.push_back(u);
  }
}

void NearTriangles::overlapping(const SurfaceMesh& mesh, const Box& box, std::vector<Triangle>& found) const {
  found.clear();
  boxes_.query_unsorted(box, found);
  std::erase_if(found, [&](Triangle t) { return !triangle_box(mesh, t, mesh.positions(), 0).overlaps(box); });
  base::sort_unique(found);
}

std::size_t NearTriangles::memory_bytes() const {
  std::size_t lists = near_.capacity() * sizeof(List);
  for (const List& list : near_)
    if (list.capacity() > List::internal_capacity()) lists += list.capacity() * sizeof(Triangle);
  return lists + boxes_.memory_bytes() + places_.capacity() * sizeof(Vec3) + is_moved_.capacity() +
         corners_.capacity() * sizeof(corners_[0]) + stale_.capacity() * sizeof(Triangle) + is_stale_.capacity();
}

}  // namespace lostopos
