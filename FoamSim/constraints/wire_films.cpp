#include "FoamSim/constraints/wire_films.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>

#include "Base/lists/erase_repeated.h"
#include "FoamSim/linear/dense_solve.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

// 2 × area × normal of the film, out of the lower of its regions.
Vec3 normal_out_of_low(const SurfaceMesh& mesh, Triangle t) {
  const auto [a, b, c] = mesh.vertices(t);
  const Vec3& x = mesh.position(a);
  return RegionPair::sign(mesh.labels(t)) * (mesh.position(b) - x).cross(mesh.position(c) - x);
}

// Whether a region has an odd number of the triangles: there the films do not close it off.
bool is_open(const SurfaceMesh& mesh, std::span<const Triangle> films) {
  std::vector<Region> odd;
  for (Triangle t : films)
    for (Region r : {mesh.labels(t).p, mesh.labels(t).q}) {
      const auto it = std::ranges::find(odd, r);
      if (it == odd.end())
        odd.push_back(r);
      else
        odd.erase(it);
    }
  return !odd.empty();
}

std::optional<OpenEdge> open_edge(const EffectStep& step, std::span<const std::uint8_t> wired, Edge e) {
  const SurfaceMesh& mesh = step.mesh;
  auto [from, to] = mesh.vertices(e);
  if (wired[from.index()] == 0 || wired[to.index()] == 0) return {};
  std::vector<Triangle> films;
  for (Triangle t : mesh.triangles(e))
    if (!is_solid(t, step.solid)) films.push_back(t);
  if (films.empty() || !is_open(mesh, films)) return {};
  const bool along = mesh.runs_along(films[0], e) == (RegionPair::sign(mesh.labels(films[0])) > 0);
  if (!along) std::swap(from, to);
  return OpenEdge{from, to, std::move(films)};
}

// Collects normals by film and turns them into unit ones.
class FilmNormals {
 public:
  void add(RegionPair pair, const Vec3& normal) {
    const auto it = std::ranges::find(sums_, pair, &std::pair<RegionPair, Vec3>::first);
    if (it == sums_.end())
      sums_.emplace_back(pair, normal);
    else
      it->second += normal;
  }
  bool has(RegionPair pair) const {
    return std::ranges::find(sums_, pair, &std::pair<RegionPair, Vec3>::first) != sums_.end();
  }
  void append_to(std::vector<HeldFilm>& films, Vertex v) const {
    for (const auto& [pair, sum] : sums_)
      if (const double length = sum.norm(); length > 0) films.push_back({v, pair, sum / length, length / 6});
  }

 private:
  std::vector<std::pair<RegionPair, Vec3>> sums_;
};

// ΔΓ of the films, all of one vertex, by potentials of the regions; those on both sides of another film there, whose Γ
// stays, have the same.
Eigen::MatrixXd jumps_of(const EffectStep& step, std::span<const HeldFilm> films) {
  const SurfaceMesh& mesh = step.mesh;
  std::map<Region, Region> same;
  const auto find = [&same](Region r) {
    for (auto it = same.find(r); it != same.end(); it = same.find(r)) r = it->second;
    return r;
  };
  for (Triangle t : mesh.triangles(films.front().vertex)) {
    const RegionPair pair(mesh.labels(t));
    if (is_solid(t, step.solid) || std::ranges::find(films, pair, &HeldFilm::pair) != films.end()) continue;
    if (const Region low = find(pair.low), high = find(pair.high); low != high) same[high] = low;
  }
  std::map<Region, Eigen::Index> columns;
  for (const HeldFilm& film : films)
    for (Region r : {film.pair.low, film.pair.high})
      columns.emplace(find(r), static_cast<Eigen::Index>(columns.size()));
  Eigen::MatrixXd jumps =
      Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(films.size()), static_cast<Eigen::Index>(columns.size()));
  for (std::size_t i = 0; i < films.size(); ++i) {
    jumps(static_cast<Eigen::Index>(i), columns.at(find(films[i].pair.low))) += 1;
    jumps(static_cast<Eigen::Index>(i), columns.at(find(films[i].pair.high))) -= 1;
  }
  return jumps;
}

}  // namespace

WireFilms::WireFilms(const EffectStep& step, std::span<const std::uint8_t> wired) {
  const SurfaceMesh& mesh = step.mesh;
  std::map<Vertex, FilmNormals> ends;  // by vertices of open edges: of the triangles at these
  for (Vertex v : mesh.vertices()) {
    if (wired[v.index()] == 0) continue;
    for (Edge e : mesh.edges(v)) {
      if (mesh.vertices(e)[0] != v) continue;
      std::optional<OpenEdge> edge = open_edge(step, wired, e);
      if (!edge) continue;
      for (Triangle t : edge->films)
        for (Vertex end : {edge->from, edge->to})
          ends[end].add(RegionPair(mesh.labels(t)), normal_out_of_low(mesh, t).normalized());
      open_edges.push_back(std::move(*edge));
    }
  }
  for (const auto& [v, normals] : ends) normals.append_to(at_open_edges, v);
  for (Vertex v : mesh.vertices()) {
    if (wired[v.index()] == 0) continue;
    const auto ending = ends.find(v);
    FilmNormals normals;
    for (Triangle t : mesh.triangles(v)) {
      const RegionPair pair(mesh.labels(t));
      if (is_solid(t, step.solid) || (ending != ends.end() && ending->second.has(pair))) continue;
      normals.add(pair, normal_out_of_low(mesh, t));
    }
    normals.append_to(inside, v);
  }
}

ClosedCirculation::ClosedCirculation(const EffectStep& step, std::span<const HeldFilm> films) {
  for (std::size_t first = 0, end = 0; first < films.size(); first = end) {
    while (end < films.size() && films[end].vertex == films[first].vertex) ++end;
    if (end - first < 2) continue;
    const std::span<const HeldFilm> here = films.subspan(first, end - first);
    if (auto projection = projection_onto_range(jumps_of(step, here)))
      blocks_.push_back({static_cast<Eigen::Index>(first), std::move(*projection)});
  }
}

void ClosedCirculation::project(Eigen::VectorXd& change) const {
  for (const Block& block : blocks_) {
    auto part = change.segment(block.first, block.projection.rows());
    part = (block.projection * part).eval();
  }
}

std::vector<InductionSource> film_sources(const EffectStep& step, std::span<const HeldFilm> films) {
  const SurfaceMesh& mesh = step.mesh;
  std::map<std::pair<Vertex, RegionPair>, std::uint32_t> unknowns;
  for (std::uint32_t i = 0; i < films.size(); ++i) unknowns.emplace(std::pair(films[i].vertex, films[i].pair), i);
  std::vector<Triangle> triangles;
  for (const HeldFilm& film : films)
    for (Triangle t : mesh.triangles(film.vertex))
      if (!is_solid(t, step.solid) && RegionPair(mesh.labels(t)) == film.pair) triangles.push_back(t);
  base::sort_unique(triangles);
  std::vector<InductionSource> sources;
  for (Triangle t : triangles) {
    const auto& v = mesh.vertices(t);
    InductionSource source{(mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3, {}, 0};
    for (std::size_t k = 0; k < 3; ++k) {
      const auto it = unknowns.find({v[k], RegionPair(mesh.labels(t))});
      if (it == unknowns.end()) continue;
      const Vec3 opposite = mesh.position(v[(k + 2) % 3]) - mesh.position(v[(k + 1) % 3]);
      source.parts[source.count++] = {it->second, -RegionPair::sign(mesh.labels(t)) * opposite};
    }
    sources.push_back(source);
  }
  return sources;
}

std::vector<InductionSource> segment_sources(std::span<const Vec3> positions, std::span<const OpenEdge> edges) {
  std::vector<InductionSource> sources;
  for (std::uint32_t k = 0; k < edges.size(); ++k) {
    const Vec3 &from = positions[edges[k].from.index()], &to = positions[edges[k].to.index()];
    InductionSource source{(from + to) / 2, {}, 0};
    source.parts[source.count++] = {k, (to - from).normalized()};
    sources.push_back(source);
  }
  return sources;
}

}  // namespace foamsim
