#include "LosTopos/topology/site.h"

#include <algorithm>
#include <cmath>

#include "LosTopos/geometry/distance.h"
#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

struct FilmNormal {
  Labels labels;
  Vec3 area = Vec3::Zero();
};

}  // namespace

bool Site::uses(Vertex v) const {
  return std::ranges::find(vertices(), v) != vertices().end();
}

Site site_at(const SurfaceMesh& mesh, Vertex v) {
  Site site;
  site.place = {{v}, {1}, 1};
  site.point = mesh.position(v);
  site.vertex = v;
  return site;
}

Site site_on(const SurfaceMesh& mesh, Edge e, double t) {
  const auto [a, b] = mesh.vertices(e);
  if (!(t > 0)) return site_at(mesh, a);
  if (!(t < 1)) return site_at(mesh, b);
  Site site;
  site.place = {{a, b}, {1 - t, t}, 2};
  site.point = (1 - t) * mesh.position(a) + t * mesh.position(b);
  site.edge = e;
  return site;
}

Site site_in(const SurfaceMesh& mesh, Triangle t, const Vec3& weights) {
  const auto& v = mesh.vertices(t);
  for (int i = 0; i < 3; ++i) {
    if (weights[i] > 0) continue;
    const Edge e = mesh.edges(t)[static_cast<std::size_t>(i)];
    const bool is_second = mesh.vertices(e)[1] == v[static_cast<std::size_t>((i + 2) % 3)];
    return site_on(mesh, e, is_second ? weights[(i + 2) % 3] : weights[(i + 1) % 3]);
  }
  Site site;
  site.place = {{v[0], v[1], v[2]}, {weights[0], weights[1], weights[2]}, 3};
  site.point = weights[0] * mesh.position(v[0]) + weights[1] * mesh.position(v[1]) + weights[2] * mesh.position(v[2]);
  site.triangle = t;
  return site;
}

Site settled(const SurfaceMesh& mesh, const Site& site, double reach) {
  if (site.vertex.valid()) return site;
  Vertex nearest;
  double least = reach;
  for (Vertex v : site.vertices()) {
    const double distance = (mesh.position(v) - site.point).norm();
    if (!(distance < least)) continue;
    least = distance;
    nearest = v;
  }
  if (nearest.valid()) return site_at(mesh, nearest);
  if (!site.triangle.valid()) return site;
  Site on_side = site;
  least = reach;
  for (Edge e : mesh.edges(site.triangle)) {
    const auto [a, b] = mesh.vertices(e);
    const PointSegmentDistance d = point_segment_distance(site.point, mesh.position(a), mesh.position(b));
    if (!(d.distance < least)) continue;
    least = d.distance;
    on_side = site_on(mesh, e, d.t);
  }
  return on_side;
}

SurfaceMesh::TriangleList triangles_at(const SurfaceMesh& mesh, const Site& site) {
  if (site.triangle.valid()) return {site.triangle};
  const auto list = site.vertex.valid() ? mesh.triangles(site.vertex) : mesh.triangles(site.edge);
  return {list.begin(), list.end()};
}

VertexRank rank(const SurfaceMesh& mesh, const Site& site) {
  if (site.vertex.valid()) return rank(mesh, site.vertex);
  return site.edge.valid() && is_border(mesh, site.edge) ? VertexRank::border : VertexRank::film;
}

bool is_held(const VertexAttribute<Hold>& held, const Site& site) {
  return std::ranges::all_of(site.vertices(), [&](Vertex v) { return is_held(held[v]); });
}

double transversality(const SurfaceMesh& mesh, const Site& site, const Vec3& direction) {
  boost::container::small_vector<FilmNormal, 4> films;
  for (Triangle t : triangles_at(mesh, site)) {
    const Labels labels = mesh.labels(t);
    auto film = std::ranges::find_if(
        films, [&](const FilmNormal& f) { return f.labels == labels || f.labels == labels.flipped(); });
    if (film == films.end()) film = films.insert(films.end(), FilmNormal{labels});
    film->area += (film->labels == labels ? 1.0 : -1.0) * area_vector(mesh, t);
  }
  double largest = 0;
  for (const FilmNormal& film : films) {
    const double size = film.area.norm();
    if (size > 0) largest = std::max(largest, std::abs(film.area.dot(direction)) / size);
  }
  return largest;
}

}  // namespace lostopos
