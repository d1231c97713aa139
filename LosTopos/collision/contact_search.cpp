#include "LosTopos/collision/contact_search.h"

#include <tbb/enumerable_thread_specific.h>

#include <algorithm>
#include <limits>
#include <utility>

#include "Base/lists/erase_repeated.h"
#include "Base/parallel/for_each.h"
#include "Base/timing/stopwatch.h"

namespace lostopos {
namespace {

// Triangles that are searched at a time: their pairs stay in the cache until they are tested.
constexpr std::size_t batch = 64;
// Triangles between two looks at whether there are too many contacts; and pairs a triangle that make them fewer.
constexpr std::size_t smallest_block = batch;
constexpr std::size_t largest_block = 8192;
constexpr std::size_t many_pairs = 50;
// Distances are good to some 20 units in the last place of the pair's extent, which is two boxes at most.
constexpr double distance_error = 1e-12;
constexpr double least_gap_over_proximity = 1e-3;

Box swept_box(const Motion& motion, Vertex v, double margin) {
  const Vec3& start = motion.starts()[v.index()];
  const Vec3& end = motion.ends()[v.index()];
  return {(start.cwiseMin(end).array() - margin).matrix(), (start.cwiseMax(end).array() + margin).matrix()};
}

Box united(const Box& a, const Box& b) {
  return {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
}

template <class T>
void append(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

void sort_by_pair(std::vector<Contact>& contacts) {
  std::ranges::sort(contacts, {}, &Contact::pair);
  base::erase_repeated(contacts, &Contact::pair);
}

}  // namespace

struct ContactSearch::Scratch {
  std::vector<Triangle> near;
  std::vector<ElementPair> pairs;
  FoundContacts found;
  std::size_t pair_count = 0;
  double broad_phase_seconds = 0;
  double ccd_seconds = 0;
};

struct ContactSearch::Scratches {
  tbb::enumerable_thread_specific<Scratch> of_threads;
};

ContactSearch::ContactSearch(const SurfaceMesh& mesh, Motion& motion, double proximity_epsilon,
                             MoveStatistics& statistics, NearTriangles* near, base::Interruption interruption)
    : mesh_(mesh),
      motion_(motion),
      statistics_(statistics),
      scale_{proximity_epsilon, proximity_epsilon, least_gap_over_proximity * proximity_epsilon},
      margin_(0.5 * proximity_epsilon),
      near_(near && near->margins().reach >= proximity_epsilon ? near : nullptr),
      interruption_(std::move(interruption)),
      owned_(mesh.triangle_slots(), 0),
      is_subject_(mesh.triangle_slots(), 0) {}

FoundContacts ContactSearch::all() {
  const base::Stopwatch watch;
  motion_.forget_changes();
  uses_lists_ = near_ && near_->follow(mesh_, motion_.starts(), motion_.ends());
  if (uses_lists_) {
    begin_with_lists();
  } else {
    begin_with_boxes();
    for (Triangle t : mesh_.triangles()) add_subject(t);
  }
  scale_.safe = std::max(scale_.proximity, distance_error * largest_extent());
  statistics_.broad_phase_seconds += watch.seconds();
  return search(false);
}

// Triangles with nothing near them are left out.
void ContactSearch::begin_with_lists() {
  near_->complete(mesh_);
  for (Triangle t : mesh_.triangles()) {
    if (near_->near(t).empty()) continue;
    add_subject(t);
    note_owned(t);
  }
  // Where there are many subjects, each would note the vertices that they have in common again.
  if (!subjects_.empty()) note_boxes(3 * subjects_.size() > mesh_.vertex_count());
}

void ContactSearch::begin_with_boxes() {
  for (Triangle t : mesh_.triangles()) note_owned(t);
  note_boxes(true);
  broad_phase_.build(mesh_, motion_.starts(), motion_.ends(), margin_);
}

FoundContacts ContactSearch::again() {
  const base::Stopwatch watch;
  const auto is_covered = [this](Vertex v) { return near_->covers(v, motion_.ends()[v.index()]); };
  if (uses_lists_ && !std::ranges::all_of(motion_.changed(), is_covered)) {
    uses_lists_ = false;
    begin_with_boxes();
  }
  for (Vertex v : motion_.changed())
    for (Triangle t : mesh_.triangles(v))
      if (!uses_lists_ || !near_->near(t).empty()) add_subject(t);
  update_boxes();
  statistics_.broad_phase_seconds += watch.seconds();
  FoundContacts found = search(true);
  motion_.forget_changes();
  return found;
}

void ContactSearch::add_subject(Triangle t) {
  if (!is_subject_[t.index()]) subjects_.push_back(t);
  is_subject_[t.index()] = 1;
}

void ContactSearch::note_owned(Triangle t) {
  unsigned owned = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    if (mesh_.triangles(mesh_.edges(t)[i])[0] == t) owned |= 1u << i;
    if (mesh_.triangles(mesh_.vertices(t)[i])[0] == t) owned |= 8u << i;
  }
  owned_[t.index()] = static_cast<unsigned char>(owned);
}

void ContactSearch::note_box(Vertex v) {
  vertex_boxes_[v.index()].enclose(swept_box(motion_, v, margin_));
}

// Of all vertices, or of the subjects' alone: what subjects are near are subjects, too.
void ContactSearch::note_boxes(bool of_all) {
  vertex_boxes_.resize(mesh_.vertex_slots());
  if (of_all) {
    for (Vertex v : mesh_.vertices()) note_box(v);
  } else {
    for (Triangle t : subjects_)
      for (Vertex v : mesh_.vertices(t)) note_box(v);
  }
}

Box ContactSearch::box(Triangle t) const {
  const auto& [a, b, c] = mesh_.vertices(t);
  return united(swept_box(motion_, a, margin_), united(swept_box(motion_, b, margin_), swept_box(motion_, c, margin_)));
}

RoundedBox ContactSearch::rounded_box(std::span<const Vertex> vertices) const {
  RoundedBox united = vertex_boxes_[vertices[0].index()];
  for (Vertex v : vertices.subspan(1)) united.unite(vertex_boxes_[v.index()]);
  return united;
}

// Of the boxes of the subjects.
double ContactSearch::largest_extent() const {
  double largest = 0;
  for (Triangle t : subjects_) {
    const Box swept = box(t);
    largest = std::max(largest, (swept.high - swept.low).maxCoeff());
  }
  return largest;
}

void ContactSearch::update_boxes() {
  if (!subjects_.empty())
    for (Vertex v : motion_.changed()) note_box(v);
  if (!uses_lists_)
    for (Triangle t : subjects_) broad_phase_.set(t, box(t));
  scale_.safe = std::max(scale_.safe, distance_error * largest_extent());
}

// Whether to give up is decided between blocks, and so the same for any number of threads. They are small where there
// are many pairs.
FoundContacts ContactSearch::search(bool changed_only) {
  const std::size_t most_pairs = 200'000 + 100 * mesh_.triangle_count();
  const std::size_t most_collisions = 10'000 + 20 * mesh_.triangle_count();
  Scratches scratches;
  FoundContacts found;
  std::size_t block = smallest_block, pairs = 0;
  for (std::size_t from = 0; from < subjects_.size() && !found.too_many;) {
    interruption_.check();
    const std::size_t to = std::min(from + block, subjects_.size());
    search_block(from, to, changed_only, scratches);
    const std::size_t pairs_before = pairs;
    std::size_t collisions = 0;
    pairs = 0;
    for (const Scratch& scratch : scratches.of_threads) {
      pairs += scratch.pair_count;
      collisions += scratch.found.collisions.size();
    }
    found.too_many = pairs > most_pairs || collisions > most_collisions;
    const bool crowded = pairs - pairs_before > many_pairs * (to - from);
    block = crowded ? std::max(block / 2, smallest_block) : std::min(2 * block, largest_block);
    from = to;
  }
  gather(scratches, found);
  for (Triangle t : subjects_) is_subject_[t.index()] = 0;
  subjects_.clear();
  return found;
}

void ContactSearch::gather(const Scratches& scratches, FoundContacts& found) {
  for (const Scratch& scratch : scratches.of_threads) {
    append(found.proximities, scratch.found.proximities);
    append(found.collisions, scratch.found.collisions);
    statistics_.pairs += scratch.pair_count;
    statistics_.broad_phase_seconds += scratch.broad_phase_seconds;
    statistics_.ccd_seconds += scratch.ccd_seconds;
  }
  sort_by_pair(found.proximities);
  sort_by_pair(found.collisions);
  statistics_.collisions += found.collisions.size();
}

void ContactSearch::search_block(std::size_t first, std::size_t last, bool changed_only, Scratches& scratches) {
  base::parallel_ranges(first, last, batch, [&](std::size_t begin, std::size_t end) {
    Scratch& scratch = scratches.of_threads.local();
    for (std::size_t from = begin; from < end; from += batch) {
      base::Stopwatch watch;
      scratch.pairs.clear();
      for (std::size_t i = from; i < std::min(from + batch, end); ++i) {
        collect(subjects_[i], changed_only, scratch);
      }
      scratch.broad_phase_seconds += watch.restart();
      for (const ElementPair& pair : scratch.pairs) {
        const PairResult result = test_pair(motion_, pair, scale_);
        if (result.proximity && !changed_only) scratch.found.proximities.push_back(*result.proximity);
        if (result.collision) scratch.found.collisions.push_back(*result.collision);
      }
      scratch.pair_count += scratch.pairs.size();
      scratch.ccd_seconds += watch.seconds();
    }
  });
}

void ContactSearch::collect(Triangle t, bool changed_only, Scratch& scratch) const {
  scratch.near.clear();
  if (!uses_lists_) broad_phase_.query_unsorted(box(t), scratch.near);
  const RoundedBox box_of_t = rounded_box(mesh_.vertices(t));
  for (Triangle u : uses_lists_ ? near_->near(t) : std::span<const Triangle>(scratch.near)) {
    // Of two subjects the smaller looks at the other.
    if (u == t || (is_subject_[u.index()] && u < t)) continue;
    const RoundedBox box_of_u = rounded_box(mesh_.vertices(u));
    if (!box_of_t.may_meet(box_of_u)) continue;
    pair_vertices(t, u, box_of_u, changed_only, scratch);
    pair_vertices(u, t, box_of_t, changed_only, scratch);
    pair_edges(t, u, box_of_u, changed_only, scratch);
  }
}

// The vertices that belong to t against u.
void ContactSearch::pair_vertices(Triangle t, Triangle u, const RoundedBox& box_of_u, bool changed_only,
                                  Scratch& scratch) const {
  const unsigned owned = owned_[t.index()] >> 3u;
  if (owned == 0) return;
  const auto& [a, b, c] = mesh_.vertices(u);
  for (std::size_t i = 0; i < 3; ++i) {
    const Vertex v = mesh_.vertices(t)[i];
    if ((owned >> i & 1u) == 0 || v == a || v == b || v == c) continue;
    if (!vertex_boxes_[v.index()].may_meet(box_of_u)) continue;
    if (changed_only && !motion_.is_changed(v) && !motion_.is_changed(a) && !motion_.is_changed(b) &&
        !motion_.is_changed(c))
      continue;
    scratch.pairs.push_back({ElementPair::Kind::vertex_triangle, v.index(), u.index(), {v, a, b, c}});
  }
}

// The edges that belong to t against those that belong to u.
void ContactSearch::pair_edges(Triangle t, Triangle u, const RoundedBox& box_of_u, bool changed_only,
                               Scratch& scratch) const {
  for (std::size_t i = 0; i < 3; ++i) {
    if ((owned_[t.index()] >> i & 1u) == 0) continue;
    const Edge e = mesh_.edges(t)[i];
    const RoundedBox box_of_e = rounded_box(mesh_.vertices(e));
    if (!box_of_e.may_meet(box_of_u)) continue;
    const auto& [a, b] = mesh_.vertices(e);
    for (std::size_t j = 0; j < 3; ++j) {
      if ((owned_[u.index()] >> j & 1u) == 0) continue;
      const Edge f = mesh_.edges(u)[j];
      const auto& [c, d] = mesh_.vertices(f);
      if (a == c || a == d || b == c || b == d || !box_of_e.may_meet(rounded_box(mesh_.vertices(f)))) continue;
      if (changed_only && !motion_.is_changed(a) && !motion_.is_changed(b) && !motion_.is_changed(c) &&
          !motion_.is_changed(d))
        continue;
      if (e < f) {
        scratch.pairs.push_back({ElementPair::Kind::edge_edge, e.index(), f.index(), {a, b, c, d}});
      } else {
        scratch.pairs.push_back({ElementPair::Kind::edge_edge, f.index(), e.index(), {c, d, a, b}});
      }
    }
  }
}

}  // namespace lostopos
