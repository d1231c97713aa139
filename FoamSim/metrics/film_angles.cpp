#include "FoamSim/metrics/film_angles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <vector>

#include "Base/parallel/for_each.h"
#include "FoamSim/linear/dense_solve.h"
#include "FoamSim/metrics/half_planes.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr int fewest_rings = 2, most_rings = 4;
constexpr std::size_t enough_points = 9;  // for five coefficients

template <class T>
bool contains(const std::vector<T>& list, T element) {
  return std::ranges::find(list, element) != list.end();
}

// A film around a vertex on its edge: triangles reached across edges of two triangles, ring by ring.
class FilmPatch {
 public:
  FilmPatch(const SurfaceMesh& mesh, Vertex v, Triangle first) : mesh_(mesh), vertices_{v}, triangles_{first} {
    sector_ = first_ring(v);
    for (int ring = 2; ring <= most_rings && (ring <= fewest_rings || vertices_.size() <= enough_points); ++ring)
      add_ring();
  }
  // Without the vertex itself.
  std::span<const Vertex> neighbours() const { return std::span(vertices_).subspan(1); }
  /// Area-weighted normal of the triangles at the vertex.
  Vec3 normal() const {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 0; i < sector_; ++i) sum += facing(triangles_[i]);
    return sum.normalized();
  }

 private:
  // As the first triangle faces: one film's triangles need not all be listed with the same side in front.
  Vec3 facing(Triangle t) const {
    const Vec3 n = lostopos::area_vector(mesh_, t);
    return mesh_.labels(t) == mesh_.labels(triangles_[0]) ? n : Vec3(-n);
  }
  std::size_t first_ring(Vertex v) {
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (Edge e : mesh_.edges(triangles_[i]))
        if (std::ranges::find(mesh_.vertices(e), v) != mesh_.vertices(e).end()) cross(e);
    take_vertices(0);
    return triangles_.size();
  }
  // All triangles of the film that share a vertex with what is there, found by going round from edge to edge.
  void add_ring() {
    const std::vector<Vertex> inner = vertices_;
    const std::size_t begin = triangles_.size();
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      for (Edge e : mesh_.edges(triangles_[i]))
        if (std::ranges::any_of(mesh_.vertices(e), [&](Vertex w) { return contains(inner, w); })) cross(e);
    take_vertices(begin);
  }
  void cross(Edge e) {
    if (mesh_.triangles(e).size() != 2) return;
    for (Triangle t : mesh_.triangles(e))
      if (!contains(triangles_, t)) triangles_.push_back(t);
  }
  void take_vertices(std::size_t begin) {
    for (std::size_t i = begin; i < triangles_.size(); ++i)
      for (Vertex w : mesh_.vertices(triangles_[i]))
        if (!contains(vertices_, w)) vertices_.push_back(w);
  }

  const SurfaceMesh& mesh_;
  std::vector<Vertex> vertices_;
  std::vector<Triangle> triangles_;
  std::size_t sector_ = 0;
};

// The normal at x of the height function a s + b t + c s² + d s t + e t² over the plane with normal `up`. With less
// than five points the least coefficients that fit.
Vec3 refined_normal(const SurfaceMesh& mesh, const Vec3& x, std::span<const Vertex> points, const Vec3& up) {
  const Vec3 u = up.unitOrthogonal(), w = up.cross(u);
  double squares = 0;
  for (Vertex p : points) squares += (mesh.position(p) - x).squaredNorm();
  const double scale = std::sqrt(squares / static_cast<double>(points.size()));
  Eigen::MatrixXd rows(points.size(), 5);
  Eigen::VectorXd heights(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec3 d = (mesh.position(points[i]) - x) / scale;
    const double s = d.dot(u), t = d.dot(w), weight = 1 / d.norm();
    const auto row = static_cast<Eigen::Index>(i);
    rows.row(row) << s, t, s * s, s * t, t * t;
    rows.row(row) *= weight;
    heights[row] = weight * d.dot(up);
  }
  const Eigen::VectorXd fit = least_squares(rows, heights);
  return (up - fit[0] * u - fit[1] * w).normalized();
}

// Seen from a plane that is tilted against the tangent plane a film's heights hold cubic terms; seen from the tangent
// plane itself a sphere's hold none. So the fit is repeated from the plane it has found.
Vec3 fitted_normal(const SurfaceMesh& mesh, const Vec3& x, const FilmPatch& patch) {
  Vec3 normal = patch.normal();
  for (int i = 0; i < 3; ++i) normal = refined_normal(mesh, x, patch.neighbours(), normal);
  return normal;
}

// The two junction edges at v when there are just two, with three triangles each.
std::optional<std::array<Edge, 2>> border_edges(const SurfaceMesh& mesh, Vertex v) {
  std::array<Edge, 2> found;
  std::size_t count = 0;
  for (Edge e : mesh.edges(v)) {
    if (!mesh.is_junction(e)) continue;
    if (count == 2 || mesh.triangles(e).size() != 3) return {};
    found[count++] = e;
  }
  if (count != 2) return {};
  return found;
}

// Of the parabola through both neighbours and v, from the first to the second.
Vec3 border_tangent(const SurfaceMesh& mesh, Vertex v, const std::array<Edge, 2>& edges) {
  const Vec3 before = mesh.position(v) - mesh.position(mesh.other_vertex(edges[0], v));
  const Vec3 after = mesh.position(mesh.other_vertex(edges[1], v)) - mesh.position(v);
  return (before / before.squaredNorm() + after / after.squaredNorm()).normalized();
}

struct Place {
  Vertex vertex;
  std::array<Edge, 2> edges;
  std::array<HalfPlane, 3> planes;
};

std::array<HalfPlane, 3> film_planes(const SurfaceMesh& mesh, Vertex v, const std::array<Edge, 2>& edges) {
  const Vec3 axis = border_tangent(mesh, v, edges), u = axis.unitOrthogonal(), w = axis.cross(u);
  const Edge ahead = edges[1];
  std::array<HalfPlane, 3> planes;
  for (std::size_t i = 0; i < 3; ++i) {
    const Triangle t = mesh.triangles(ahead)[i];
    const bool along = mesh.runs_along(t, ahead) == (mesh.vertices(ahead)[0] == v);
    // A triangle that runs along the axis lies to the left of it as seen from where its normal points to.
    const Vec3 normal = fitted_normal(mesh, mesh.position(v), FilmPatch(mesh, v, t));
    const Vec3 arm = along ? normal.cross(axis) : axis.cross(normal);
    const lostopos::Labels labels = mesh.labels(t);
    planes[i] = {std::atan2(arm.dot(w), arm.dot(u)), along ? labels.q : labels.p};
  }
  return planes;
}

}  // namespace

FilmAngles film_angles(const SurfaceMesh& mesh) {
  std::vector<Place> places;
  for (Vertex v : mesh.vertices())
    if (const auto edges = border_edges(mesh, v)) places.push_back({v, *edges, {}});
  constexpr std::size_t grain = 32;
  base::parallel_for_each(places.size(), grain, [&](std::size_t i) {
    places[i].planes = film_planes(mesh, places[i].vertex, places[i].edges);
  });
  DihedralAngles angles;
  for (const Place& place : places) angles.add(place.planes);
  return {angles.rms_deviation_deg(), angles.outer_mean_deg(), angles.places()};
}

}  // namespace foamsim
