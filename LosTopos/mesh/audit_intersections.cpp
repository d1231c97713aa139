#include "LosTopos/mesh/audit_intersections.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "LosTopos/geometry/predicates.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

using Box = Eigen::AlignedBox3d;

struct BoxedEdge {
  Box box;
  Edge edge;
};

Box box_of(const SurfaceMesh& mesh, Edge e) {
  Box box(mesh.position(mesh.vertices(e)[0]));
  box.extend(mesh.position(mesh.vertices(e)[1]));
  return box;
}

// One ulp down, against rounding.
double just_below(double x) {
  return std::nextafter(x, -std::numeric_limits<double>::infinity());
}

// Edges in columns along the longest axis of the surface, those of a column sorted along it, each in the column of its
// box's low corner. Columns are at least as wide as the longest edge: a box is reached from two or three each way.
class EdgeColumns {
 public:
  EdgeColumns(const SurfaceMesh& mesh, const Box& all) {
    all.sizes().maxCoeff(&along_);
    const auto count = static_cast<double>(mesh.edge_count());
    std::vector<BoxedEdge> edges;
    edges.reserve(mesh.edge_count());
    for (Edge e : mesh.edges()) edges.push_back({box_of(mesh, e), e});
    for (const BoxedEdge& e : edges) longest_ = longest_.cwiseMax(e.box.sizes());
    low_ = all.min();
    for (int side = 0; side < 2; ++side) {
      const int axis = across(side);
      const double length = all.sizes()[axis];
      if (!(length > 0)) continue;
      columns_[side] = std::max(1, static_cast<int>(std::min(std::sqrt(count), length / longest_[axis])));
      per_length_[side] = columns_[side] / length;
    }
    std::ranges::stable_sort(edges, {}, [this](const BoxedEdge& e) {
      return std::pair(column(index(0, e.box.min()), index(1, e.box.min())), e.box.min()[along_]);
    });
    first_.assign(static_cast<std::size_t>(columns_[0] * columns_[1]) + 1, 0);
    for (const BoxedEdge& e : edges) ++first_[column(index(0, e.box.min()), index(1, e.box.min())) + 1];
    for (std::size_t c = 1; c < first_.size(); ++c) first_[c] += first_[c - 1];
    edges_ = std::move(edges);
  }

  // Calls what(edge) for every edge whose box meets `box`, until it returns false; returns whether it never has.
  template <class What>
  bool for_each_near(const Box& box, What what) const {
    const Vec3 from = (box.min() - longest_).unaryExpr(&just_below);
    for (int i = index(0, from); i <= index(0, box.max()); ++i)
      for (int j = index(1, from); j <= index(1, box.max()); ++j) {
        const auto begin = edges_.begin() + first_[column(i, j)], end = edges_.begin() + first_[column(i, j) + 1];
        auto it = std::ranges::lower_bound(begin, end, from[along_], {},
                                           [this](const BoxedEdge& e) { return e.box.min()[along_]; });
        for (; it != end && it->box.min()[along_] <= box.max()[along_]; ++it)
          if (box.intersects(it->box) && !what(it->edge)) return false;
      }
    return true;
  }

 private:
  int across(int side) const { return (along_ + 1 + side) % 3; }
  int index(int side, const Vec3& x) const {
    const double i = (x[across(side)] - low_[across(side)]) * per_length_[side];
    return i > 0 ? static_cast<int>(std::min(i, columns_[side] - 1.0)) : 0;
  }
  std::size_t column(int i, int j) const {
    return static_cast<std::size_t>(i) * static_cast<std::size_t>(columns_[1]) + static_cast<std::size_t>(j);
  }

  int along_ = 0;
  std::array<int, 2> columns_{1, 1};
  std::array<double, 2> per_length_{0, 0};
  Vec3 low_ = Vec3::Zero(), longest_ = Vec3::Zero();
  std::vector<std::ptrdiff_t> first_;  // of each column, and their end
  std::vector<BoxedEdge> edges_;
};

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
  const EdgeColumns edges(mesh, all);
  for (Triangle t : mesh.triangles()) {
    const auto [a, b, c] = corners(mesh, t);
    Box box(a);
    box.extend(b).extend(c);
    const bool more = edges.for_each_near(box, [&, a = a, b = b, c = c](Edge e) {
      const auto& ends = mesh.vertices(e);
      if (share_a_vertex(mesh, e, t) ||
          segment_triangle_intersect(mesh.position(ends[0]), mesh.position(ends[1]), a, b, c) == Crossing::none)
        return true;
      contacts.push_back({e, t});
      return contacts.size() < limit;
    });
    if (!more) break;
  }
  return contacts;
}

}  // namespace lostopos
