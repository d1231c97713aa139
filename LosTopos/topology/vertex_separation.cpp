#include "LosTopos/topology/vertex_separation.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/geometry/triangle_quality.h"
#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/invariants/shape.h"
#include "LosTopos/topology/planned_consistency.h"

namespace lostopos {
namespace {

// A separation has to save this share of the area around the vertex, lest rounding decides, or to open by this share of
// the distance between the two sides.
constexpr double least_gain = 1e-9;
// When the surface is too close for the full distance, a half and a quarter of it are tried.
constexpr int distances_tried = 3;

template <class Range, class T>
bool contains(const Range& range, const T& value) {
  return std::ranges::find(range, value) != std::ranges::end(range);
}

// Mean over the vertices opposite to v in the triangles, each counted once.
template <class Value>
Vec3 mean_over_link(const SurfaceMesh& mesh, Vertex v, const SurfaceMesh::TriangleList& triangles, const Value& value) {
  boost::container::small_vector<Vertex, 16> link;
  for (Triangle t : triangles)
    for (Vertex w : mesh.vertices(t))
      if (w != v && !contains(link, w)) link.push_back(w);
  Vec3 sum = Vec3::Zero();
  for (Vertex w : link) sum += value(w);
  return sum / static_cast<double>(link.size());
}

double planned_area(const ChangePlan& plan) {
  double sum = 0;
  for (const PlannedTriangle& t : plan.triangles) sum += triangle_area(t.corners[0], t.corners[1], t.corners[2]);
  return sum;
}

double star_area(const SurfaceMesh& mesh, Vertex v) {
  double sum = 0;
  for (Triangle t : mesh.triangles(v)) sum += area(mesh, t);
  return sum;
}

}  // namespace

// At an edge where the sector that leaves meets other films: the film that will stand between its two copies.
std::optional<Refusal> VertexSeparation::plan_new_film(Vertex v, Edge e, const Candidate& candidate) {
  const SurfaceMesh& mesh = c_.mesh;
  const auto around = mesh.triangles(e);
  const auto leaving = std::ranges::count_if(around, [&](Triangle t) { return contains(candidate.leaving, t); });
  if (leaving == 0 || leaving == static_cast<std::ptrdiff_t>(around.size())) return {};
  if (leaving != 2) return Refusal::ambiguous;
  Region before, after;
  Triangle parent;
  for (Triangle t : around) {
    if (!contains(candidate.leaving, t)) continue;
    const bool along = mesh.runs_along(t, e) == (mesh.vertices(e)[0] == v);
    const Labels labels = along ? mesh.labels(t) : mesh.labels(t).flipped();
    if (labels.p == candidate.leaving_region) {
      after = labels.q;
      parent = t;
    } else {
      before = labels.p;
    }
  }
  if (!before.valid() || !after.valid()) return Refusal::ambiguous;
  if (before == after) return {};
  const Vertex w = mesh.other_vertex(e, v);
  c_.plan.triangles.push_back({{planned_vertex, w, v},
                               {leaving_position_, mesh.position(w), staying_position_},
                               {after, before},
                               parent,
                               Vec3::Zero(),
                               false});
  return {};
}

std::optional<Refusal> VertexSeparation::plan(Vertex v, const Candidate& candidate, double distance) {
  const SurfaceMesh& mesh = c_.mesh;
  leaving_position_ = mesh.position(v) + distance / 2 * candidate.direction;
  staying_position_ = mesh.position(v) - distance / 2 * candidate.direction;
  c_.plan.clear();
  for (Triangle t : mesh.triangles(v)) {
    c_.plan.replaced.push_back(t);
    const bool leaves = contains(candidate.leaving, t);
    c_.plan.add_moved(mesh, t, v, leaves ? planned_vertex : v, leaves ? leaving_position_ : staying_position_);
  }
  for (Edge e : mesh.edges(v))
    if (const auto refusal = plan_new_film(v, e, candidate)) return refusal;
  return {};
}

// Takes in a pair of sectors (or parts) if parting them gains anything.
void VertexSeparation::consider(Vertex v, const SurfaceMesh::TriangleList& leaving,
                                const SurfaceMesh::TriangleList& other, Region leaving_region, Region other_region) {
  const SurfaceMesh& mesh = c_.mesh;
  auto position = [&](Vertex w) { return mesh.position(w); };
  // In a wall both results stay there.
  const Vec3 across =
      free_part(c_.held[v], mean_over_link(mesh, v, leaving, position) - mean_over_link(mesh, v, other, position));
  const double width = across.norm();
  if (!(width > 0)) return;
  Candidate candidate{leaving, leaving_region, other_region, across / width, 0};
  if (rule_ == SeparationRule::flow) {
    const Vec3 opening = mean_over_link(mesh, v, leaving, flow_) - mean_over_link(mesh, v, other, flow_);
    candidate.gain = opening.dot(candidate.direction) / width;
  } else {
    if (plan(v, candidate, pull_apart_)) return;
    const double before = star_area(mesh, v);
    candidate.gain = (before - planned_area(c_.plan)) / before;
  }
  if (candidate.gain > least_gain) candidates_.push_back(std::move(candidate));
}

void VertexSeparation::list_candidates(Vertex v) {
  candidates_.clear();
  const Neighbourhood around = neighbourhood(c_.mesh, v);
  if (around.parts.size() > 1) {
    for (std::size_t i = 0; i < around.parts.size(); ++i) {
      SurfaceMesh::TriangleList others;
      for (std::size_t j = 0; j < around.parts.size(); ++j)
        if (j != i) others.insert(others.end(), around.parts[j].begin(), around.parts[j].end());
      const Labels a = c_.mesh.labels(around.parts[i][0]), b = c_.mesh.labels(others[0]);
      consider(v, around.parts[i], others, a.p == air ? a.q : a.p, b.p == air ? b.q : b.p);
    }
    return;
  }
  const auto& sectors = around.sectors;
  for (std::size_t i = 0; i < sectors.size(); ++i)
    for (std::size_t j = 0; j < sectors.size(); ++j) {
      if (i == j) continue;
      const bool touch =
          std::ranges::any_of(sectors[i].triangles, [&](Triangle t) { return contains(sectors[j].triangles, t); });
      if (!touch) consider(v, sectors[i].triangles, sectors[j].triangles, sectors[i].region, sectors[j].region);
    }
}

std::optional<Refusal> VertexSeparation::check_plan(Vertex v, const Candidate& candidate, double distance) {
  if (const auto refusal = plan(v, candidate, distance)) return refusal;
  if (!keeps_orientation(c_.plan, c_.limits)) return Refusal::inverted_normal;
  if (!planned_triangles_are_apart(c_.plan)) return Refusal::intersection;
  if (!planned_labels_are_consistent(c_.plan, planned_vertex) || !planned_labels_are_consistent(c_.plan, v))
    return Refusal::labels;
  const Vec3 start = c_.mesh.position(v);
  c_.motion.clear();
  for (const PlannedTriangle& t : c_.plan.triangles) {
    StarMotion::Points points;
    for (std::size_t i = 0; i < 3; ++i) {
      const bool moves = t.vertices[i] == v || t.vertices[i] == planned_vertex;
      points[i] = {t.vertices[i], {moves ? start : t.corners[i], t.corners[i]}, moves};
    }
    c_.motion.add(points);
  }
  const std::array<Vertex, 1> moving = {v};
  if (!c_.guard.is_free(c_.motion, {moving, Edge()})) return Refusal::intersection;
  return {};
}

void VertexSeparation::carry_out(Vertex v) {
  regions_.clear();
  for (const PlannedTriangle& t : c_.plan.triangles)
    if (t.old_normal.isZero(0)) {
      regions_.push_back(std::min(t.labels.p, t.labels.q));
      regions_.push_back(std::max(t.labels.p, t.labels.q));
    }
  base::sort_unique(regions_);
  SeparationEvent event{v, Vertex(), staying_position_, leaving_position_, {}};
  c_.notify(&OperationObserver::before_separation, event);
  c_.mesh.set_position(v, staying_position_);
  event.added = added_ = c_.mesh.add_vertex(leaving_position_);
  event.triangles = c_.carry_out(added_);
  c_.notify(&OperationObserver::after_separation, event);
}

std::optional<Refusal> VertexSeparation::attempt(Vertex v) {
  if (is_held(c_.held[v])) return Refusal::held;
  list_candidates(v);
  if (candidates_.empty()) return Refusal::not_better;
  std::ranges::stable_sort(candidates_, std::ranges::greater{}, &Candidate::gain);
  std::optional<Refusal> first_refusal;
  for (const Candidate& candidate : candidates_) {
    double distance = pull_apart_;
    for (int i = 0; i < distances_tried; ++i, distance /= 2) {
      const auto refusal = check_plan(v, candidate, distance);
      if (!refusal) {
        carry_out(v);
        const auto [a, b] = std::minmax(candidate.leaving_region, candidate.other_region);
        regions_.insert(regions_.begin(), {a, b});
        return {};
      }
      if (!first_refusal) first_refusal = refusal;
    }
  }
  return first_refusal;
}

}  // namespace lostopos
