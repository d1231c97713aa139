#include "MultiTracker/flows/area_gradient.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "LosTopos/mesh/for_each_living.h"

namespace multitracker {

using lostopos::Edge;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr double shortest_share = 0.2;  // of an edge's length, that a substep leaves
constexpr int most_parts = 100;

// −2 ∂A/∂x_v, A the area of all triangles.
Vec3 area_velocity(const SurfaceMesh& mesh, const std::vector<Vec3>& x, Vertex v) {
  Vec3 velocity = Vec3::Zero();
  for (lostopos::Triangle t : mesh.triangles(v)) {
    const auto& corners = mesh.vertices(t);
    const auto i = static_cast<std::size_t>(std::ranges::find(corners, v) - corners.begin());
    const Vec3 &a = x[v.index()], &b = x[corners[(i + 1) % 3].index()], &c = x[corners[(i + 2) % 3].index()];
    const Vec3 twice_area = (b - a).cross(c - a);
    const double norm = twice_area.norm();
    if (norm > 0) velocity -= twice_area.cross(c - b) / norm;
  }
  return velocity;
}

// How long the ends of an edge may go at their velocities before it is a fifth as long.
double time_to_shorten(const Vec3& d, const Vec3& w) {
  const double closing = -d.dot(w), speed = w.squaredNorm();
  if (!(closing > 0)) return std::numeric_limits<double>::infinity();
  const double discriminant = closing * closing - speed * (1 - shortest_share * shortest_share) * d.squaredNorm();
  if (!(discriminant > 0)) return std::numeric_limits<double>::infinity();
  return (closing - std::sqrt(discriminant)) / speed;
}

double longest_part(const SurfaceMesh& mesh, const std::vector<Vec3>& x, const std::vector<Vec3>& velocity) {
  double longest = std::numeric_limits<double>::infinity();
  for (Edge e : mesh.edges()) {
    const auto [a, b] = mesh.vertices(e);
    longest =
        std::min(longest, time_to_shorten(x[b.index()] - x[a.index()], velocity[b.index()] - velocity[a.index()]));
  }
  return longest;
}

double shortest_edge(const SurfaceMesh& mesh, const std::vector<Vec3>& x, Vertex v) {
  double shortest = std::numeric_limits<double>::infinity();
  for (Edge e : mesh.edges(v))
    shortest = std::min(shortest, (x[mesh.other_vertex(e, v).index()] - x[v.index()]).norm());
  return shortest;
}

}  // namespace

std::vector<Vec3> AreaGradientFlow::predicted(const FlowStep& step) const {
  const SurfaceMesh& mesh = step.mesh;
  std::vector<Vec3> x(mesh.positions().begin(), mesh.positions().end());
  std::vector<Vec3> velocity(x.size(), Vec3::Zero()), ends;
  double left = step.dt;
  for (int part = 1; part <= most_parts && left > 0; ++part) {
    lostopos::for_each_vertex(mesh, [&](Vertex v) {
      velocity[v.index()] = lostopos::free_part(step.held[v.index()], area_velocity(mesh, x, v));
    });
    const bool last = part == most_parts;
    const double dt = last ? left : std::min(left, longest_part(mesh, x, velocity));
    ends = x;
    lostopos::for_each_vertex(mesh, [&](Vertex v) {
      Vec3 way = dt * velocity[v.index()];
      if (last) {
        const double limit = (1 - shortest_share) / 2 * shortest_edge(mesh, x, v), length = way.norm();
        if (length > limit) way *= limit / length;
      }
      ends[v.index()] += way;
    });
    x.swap(ends);
    left -= dt;
  }
  return x;
}

}  // namespace multitracker
