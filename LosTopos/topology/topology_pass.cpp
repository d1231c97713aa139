#include "LosTopos/topology/topology_pass.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"
#include "Base/timing/stopwatch.h"
#include "LosTopos/geometry/distance.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/topology/region_parts.h"

namespace lostopos {
namespace {

// Places nearer to a vertex than this share of h̄ are moved to it before they are joined.
constexpr double snap_reach = 0.25;
// No vertex is put nearer than this share of h̄ to those of the edge or triangle that it divides: or else small
// triangles would be near each other, be divided again, and so on without end.
constexpr double smallest_division = 0.15;
// Edges shorter than this share of the merge distance are merged unless the options say otherwise. It leaves the edges
// alone that separations open.
constexpr double edge_merge_share = 0.5;
// Where two stars have a vertex in common, only films that lie over each other are snapped, not neighbours in a film:
// the line between the two places has to be within 37° of both normals.
constexpr double min_transversality = 0.8;

bool are_alive(const SurfaceMesh& mesh, const ElementPair& pair) {
  if (pair.kind == ElementPair::Kind::vertex_triangle) {
    const Vertex v(pair.first);
    const Triangle t(pair.second);
    if (!mesh.alive(v) || !mesh.alive(t)) return false;
    const auto& corners = mesh.vertices(t);
    return corners[0] == pair.vertices[1] && corners[1] == pair.vertices[2] && corners[2] == pair.vertices[3];
  }
  const Edge e(pair.first), f(pair.second);
  if (!mesh.alive(e) || !mesh.alive(f)) return false;
  return mesh.vertices(e) == std::array{pair.vertices[0], pair.vertices[1]} &&
         mesh.vertices(f) == std::array{pair.vertices[2], pair.vertices[3]};
}

std::array<Site, 2> sites_of(const SurfaceMesh& mesh, const NearPair& near) {
  const auto& w = near.weights;
  if (near.pair.kind == ElementPair::Kind::vertex_triangle)
    return {site_at(mesh, Vertex(near.pair.first)), site_in(mesh, Triangle(near.pair.second), {w[1], w[2], w[3]})};
  return {site_on(mesh, Edge(near.pair.first), w[1]), site_on(mesh, Edge(near.pair.second), w[3])};
}

// The corners of the triangles at the site, ascending.
std::vector<Vertex> star_vertices(const SurfaceMesh& mesh, const Site& site) {
  std::vector<Vertex> list;
  for (Triangle t : triangles_at(mesh, site)) list.insert(list.end(), mesh.vertices(t).begin(), mesh.vertices(t).end());
  base::sort_unique(list);
  return list;
}

// Whether a vertex at the site would be at least `room` away from those it lies between.
bool has_room(const SurfaceMesh& mesh, const Site& site, double room) {
  return site.vertex.valid() ||
         std::ranges::all_of(site.vertices(), [&](Vertex v) { return (mesh.position(v) - site.point).norm() >= room; });
}

}  // namespace

TopologyPass::TopologyPass(RemeshContext& context, const TopologyOptions& options, VertexSeparation::Flow flow,
                           TopologyStatistics& statistics)
    : c_(context),
      options_(options),
      statistics_(statistics),
      merge_(context),
      separation_(context, options.separation, options.pull_apart * context.options.target_edge, std::move(flow)),
      merge_distance_(options.merge_distance * context.options.target_edge) {}

void TopologyPass::note(TopologyOperation kind, std::vector<Region> regions, const Vec3& position) {
  statistics_.events.push_back({kind, std::move(regions), position});
}

std::vector<Region> TopologyPass::regions_at(const Site& a, const Site& b) const {
  std::vector<Region> regions;
  for (const Site* site : {&a, &b})
    for (Triangle t : triangles_at(c_.mesh, *site)) {
      regions.push_back(c_.mesh.labels(t).p);
      regions.push_back(c_.mesh.labels(t).q);
    }
  base::sort_unique(regions);
  return regions;
}

// Films under tension part again where they touch at a point only. A first contact is worth making when it can become
// one of at least a triangle: two neighbours of one of the places are near the other's surface, too.
bool TopologyPass::can_last(const Site& a, const Site& b) const {
  if (options_.separation != SeparationRule::area || !options_.separate) return true;
  const std::vector<Vertex> link_a = star_vertices(c_.mesh, a), link_b = star_vertices(c_.mesh, b);
  if (std::ranges::any_of(link_a, [&](Vertex v) { return std::ranges::binary_search(link_b, v); })) return true;
  auto near_neighbours = [this](const std::vector<Vertex>& link, const Site& own, const Site& other) {
    const auto star = triangles_at(c_.mesh, other);
    return std::ranges::count_if(link, [&](Vertex v) {
      return !own.uses(v) && std::ranges::any_of(star, [&](Triangle t) {
        const auto [x, y, z] = corners(c_.mesh, t);
        return point_triangle_distance(c_.mesh.position(v), x, y, z).distance < merge_distance_;
      });
    });
  };
  return near_neighbours(link_a, a, b) + near_neighbours(link_b, b, a) >= 2;
}

// Snaps at vertices of the two elements where they are near, or else at the nearest points themselves.
std::optional<Refusal> TopologyPass::snap(const NearPair& near) {
  const auto [a, b] = sites_of(c_.mesh, near);
  const PlaceMerge::Rules rules{.min_transversality = min_transversality,
                                .direction = (b.point - a.point).stableNormalized()};
  const double reach = snap_reach * c_.options.target_edge;
  const Site at_a = settled(c_.mesh, a, reach), at_b = settled(c_.mesh, b, reach);
  if (!can_last(at_a, at_b)) return Refusal::not_better;
  std::vector<Region> regions = regions_at(at_a, at_b);
  std::optional<Refusal> refusal = merge_.attempt(at_a, at_b, rules);
  const bool moved = at_a.point != a.point || at_b.point != b.point;
  const double room = smallest_division * c_.options.target_edge;
  if (refusal && moved && has_room(c_.mesh, a, room) && has_room(c_.mesh, b, room))
    refusal = merge_.attempt(a, b, rules);
  if (refusal) return refusal;
  statistics_.cancelled_triangles += merge_.cancelled();
  note(TopologyOperation::snap, std::move(regions), merge_.position());
  return {};
}

void TopologyPass::list_result_star(std::vector<Triangle>& list) const {
  if (!merge_.result().valid()) return;
  const auto star = c_.mesh.triangles(merge_.result());
  list.insert(list.end(), star.begin(), star.end());
}

void TopologyPass::snap_near_places() {
  OperationCounts& counts = statistics_[TopologyOperation::snap];
  const base::TimedScope timed(counts.seconds);
  std::vector<NearPair> pairs = near_pairs(c_.mesh, merge_distance_, c_.index.given());
  for (int sweep = 0; sweep < options_.max_sweeps && !pairs.empty(); ++sweep) {
    std::vector<Triangle> changed;
    for (const NearPair& listed : pairs) {
      c_.options.interruption.check();
      if (!are_alive(c_.mesh, listed.pair)) continue;
      const NearPair near = measured(c_.mesh, listed.pair);
      if (!(near.distance < merge_distance_)) continue;
      const auto refusal = snap(near);
      counts.count(refusal);
      if (!refusal) list_result_star(changed);
    }
    std::erase_if(changed, [this](Triangle t) { return !c_.mesh.alive(t); });
    base::sort_unique(changed);
    pairs = near_pairs(c_.mesh, c_.index, changed, merge_distance_);
  }
}

void TopologyPass::merge_short_edges() {
  OperationCounts& counts = statistics_[TopologyOperation::edge_merge];
  const base::TimedScope timed(counts.seconds);
  const double shortest =
      options_.merge_edge > 0 ? options_.merge_edge * c_.options.target_edge : edge_merge_share * merge_distance_;
  const PlaceMerge::Rules rules{.joined_vertices = true};
  std::vector<Edge> list;
  for (Edge e : c_.mesh.edges())
    if (length(c_.mesh, e) < shortest) list.push_back(e);
  for (int sweep = 0; sweep < options_.max_sweeps && !list.empty(); ++sweep) {
    std::ranges::stable_sort(list, {}, [this](Edge e) { return length(c_.mesh, e); });
    std::vector<Edge> next;
    for (Edge e : list) {
      c_.options.interruption.check();
      if (!c_.mesh.alive(e) || !(length(c_.mesh, e) < shortest)) continue;
      const Site a = site_at(c_.mesh, c_.mesh.vertices(e)[0]), b = site_at(c_.mesh, c_.mesh.vertices(e)[1]);
      std::vector<Region> regions = regions_at(a, b);
      const auto refusal = merge_.attempt(a, b, rules);
      counts.count(refusal);
      if (refusal) continue;
      statistics_.cancelled_triangles += merge_.cancelled();
      note(TopologyOperation::edge_merge, std::move(regions), merge_.position());
      if (!merge_.result().valid()) continue;
      for (Edge f : c_.mesh.edges(merge_.result()))
        if (length(c_.mesh, f) < shortest) next.push_back(f);
    }
    std::erase_if(next, [this](Edge e) { return !c_.mesh.alive(e); });
    base::sort_unique(next);
    list.swap(next);
  }
}

// Contracts the region's edges, shortest first, until it has no film left. Each contraction takes a vertex away.
bool TopologyPass::collapse_region(Region region, std::vector<Triangle> boundary) {
  OperationCounts& counts = statistics_[TopologyOperation::region_collapse];
  const PlaceMerge::Rules rules{.joined_vertices = true, .keeps_orientation = false};
  std::vector<Edge> edges;
  std::optional<Refusal> refusal;
  const std::size_t most = 3 * boundary.size();
  for (std::size_t i = 0; i < most && !boundary.empty(); ++i) {
    c_.options.interruption.check();
    edges.clear();
    for (Triangle t : boundary) edges.insert(edges.end(), c_.mesh.edges(t).begin(), c_.mesh.edges(t).end());
    base::sort_unique(edges);
    std::ranges::stable_sort(edges, {}, [this](Edge e) { return length(c_.mesh, e); });
    std::vector<Vertex> corners;
    for (Triangle t : boundary) corners.insert(corners.end(), c_.mesh.vertices(t).begin(), c_.mesh.vertices(t).end());
    base::sort_unique(corners);
    bool merged = false;
    for (Edge e : edges) {
      const auto [a, b] = c_.mesh.vertices(e);
      const auto outcome = merge_.attempt(site_at(c_.mesh, a), site_at(c_.mesh, b), rules);
      if (!outcome) {
        merged = true;
        statistics_.cancelled_triangles += merge_.cancelled();
        break;
      }
      if (!refusal) refusal = outcome;
    }
    if (!merged) break;
    boundary.clear();
    for (Vertex v : corners) {
      if (!c_.mesh.alive(v)) continue;
      for (Triangle t : c_.mesh.triangles(v)) {
        const bool of_part = std::ranges::all_of(
            c_.mesh.vertices(t), [&](Vertex corner) { return std::ranges::binary_search(corners, corner); });
        if (of_part && c_.mesh.labels(t).has(region)) boundary.push_back(t);
      }
    }
    base::sort_unique(boundary);
  }
  counts.count(boundary.empty() ? std::optional<Refusal>() : refusal.value_or(Refusal::not_better));
  return boundary.empty();
}

void TopologyPass::collapse_small_regions() {
  const base::TimedScope timed(statistics_[TopologyOperation::region_collapse].seconds);
  const SmallParts small{.diagonal = options_.smallest_region * c_.options.target_edge, .thickness = merge_distance_};
  for (RegionPart& part : small_region_parts(c_.mesh, small)) {
    std::erase_if(part.boundary, [&](Triangle t) { return !c_.mesh.alive(t) || !c_.mesh.labels(t).has(part.region); });
    if (part.boundary.empty()) continue;
    std::vector<Region> regions = part.neighbours;
    regions.insert(regions.begin(), part.region);
    if (collapse_region(part.region, part.boundary))
      note(TopologyOperation::region_collapse, std::move(regions), part.centre);
  }
}

void TopologyPass::separate_vertices() {
  OperationCounts& counts = statistics_[TopologyOperation::separation];
  const base::TimedScope timed(counts.seconds);
  std::vector<Vertex> list;
  for (Vertex v : c_.mesh.vertices())
    if (!is_complete(c_.mesh, v)) list.push_back(v);
  incomplete_ = list.size();
  for (int sweep = 0; sweep < options_.max_sweeps && !list.empty(); ++sweep) {
    std::vector<Vertex> next;
    for (Vertex v : list) {
      c_.options.interruption.check();
      const Vec3 position = c_.mesh.position(v);
      const auto refusal = separation_.attempt(v);
      counts.count(refusal);
      if (refusal) {
        refused_.emplace_back(v, *refusal);
        continue;
      }
      incomplete_.reset();
      note(TopologyOperation::separation, separation_.regions(), position);
      for (Vertex changed : {v, separation_.added()}) {
        next.push_back(changed);
        for (Edge e : c_.mesh.edges(changed)) next.push_back(c_.mesh.other_vertex(e, changed));
      }
    }
    base::sort_unique(next);
    std::erase_if(next, [this](Vertex v) { return is_complete(c_.mesh, v); });
    list.swap(next);
  }
}

void TopologyPass::count_what_is_left() {
  std::ranges::stable_sort(refused_, {}, &std::pair<Vertex, Refusal>::first);
  const auto count = [this](Vertex v) {
    ++statistics_.incomplete_vertices;
    const auto last = std::ranges::upper_bound(refused_, v, {}, &std::pair<Vertex, Refusal>::first);
    if (last != refused_.begin() && std::prev(last)->first == v)
      ++statistics_.incomplete_by_refusal[static_cast<std::size_t>(std::prev(last)->second)];
  };
  if (incomplete_) {  // all were tried, once, and refused
    for (const auto& [v, refusal] : refused_) count(v);
    return;
  }
  for (Vertex v : c_.mesh.vertices())
    if (!is_complete(c_.mesh, v)) count(v);
}

}  // namespace lostopos
