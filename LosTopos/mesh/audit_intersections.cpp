#include "LosTopos/mesh/audit_intersections.h"

#include <Eigen/Geometry>
#include <algorithm>

#include "LosTopos/geometry/predicates.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

using Box = Eigen::AlignedBox3d;

struct BoxedEdge {
  Box box;
  Edge edge;
};

std::vector<BoxedEdge> edges_sorted_along(const SurfaceMesh& mesh, int axis) {
  std::vector<BoxedEdge> boxed;
  boxed.reserve(mesh.edge_count());
  for (Edge e : mesh.edges()) {
    Box box(mesh.position(mesh.vertices(e)[0]));
    box.extend(mesh.position(mesh.vertices(e)[1]));
    boxed.push_back({box, e});
  }
  std::ranges::stable_sort(boxed, {}, [axis](const BoxedEdge& b) { return b.box.min()[axis]; });
  return boxed;
}

bool share_a_vertex(const SurfaceMesh& mesh, Edge e, Triangle t) {
  return std::ranges::any_of(mesh.vertices(t),
                             [&](Vertex v) { return v == mesh.vertices(e)[0] || v == mesh.vertices(e)[1]; });
}

}  // namespace

std::vector<EdgeTriangleContact> edge_triangle_contacts(const SurfaceMesh& mesh, std::size_t limit) {
  Box all;
  for (Vertex v : mesh.vertices()) all.extend(mesh.position(v));
  std::vector<EdgeTriangleContact> contacts;
  if (all.isEmpty()) return contacts;
  int axis = 0;
  all.sizes().maxCoeff(&axis);
  const std::vector<BoxedEdge> edges = edges_sorted_along(mesh, axis);
  double longest = 0;
  for (const BoxedEdge& e : edges) longest = std::max(longest, e.box.sizes()[axis]);

  for (Triangle t : mesh.triangles()) {
    const auto [a, b, c] = corners(mesh, t);
    Box box(a);
    box.extend(b).extend(c);
    // An edge that reaches into the box starts at most one longest edge before it; one ulp more against rounding.
    const double from = std::nextafter(box.min()[axis] - longest, -std::numeric_limits<double>::infinity());
    auto it = std::ranges::lower_bound(edges, from, {}, [axis](const BoxedEdge& e) { return e.box.min()[axis]; });
    for (; it != edges.end() && it->box.min()[axis] <= box.max()[axis]; ++it) {
      if (!box.intersects(it->box) || share_a_vertex(mesh, it->edge, t)) continue;
      const auto& ends = mesh.vertices(it->edge);
      if (segment_triangle_intersect(mesh.position(ends[0]), mesh.position(ends[1]), a, b, c) == Crossing::none)
        continue;
      contacts.push_back({it->edge, t});
      if (contacts.size() >= limit) return contacts;
    }
  }
  return contacts;
}

}  // namespace lostopos
