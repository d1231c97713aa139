#include "FoamSim/studies/stability/shapes/clusters.h"

#include <Eigen/Geometry>
#include <cmath>
#include <map>

#include "Base/error.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim {

using lostopos::air;
using lostopos::Labels;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

using Cell = std::array<long, 3>;

class BlockBuilder {
 public:
  BlockBuilder(const Cell& cells, long k) : cells_(cells), k_(k) {}

  SurfaceMesh build() {
    Cell at{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
      for (at[axis] = 0; at[axis] <= cells_[axis]; ++at[axis])
        for (at[v] = 0; at[v] < cells_[v]; ++at[v])
          for (at[u] = 0; at[u] < cells_[u]; ++at[u]) add_face(axis, at);
    }
    return std::move(mesh_);
  }

 private:
  Region region(const Cell& c) const {
    for (std::size_t i = 0; i < 3; ++i)
      if (c[i] < 0 || c[i] >= cells_[i]) return air;
    return Region(static_cast<std::size_t>(1 + c[0] + cells_[0] * (c[1] + cells_[1] * c[2])));
  }

  // The face of cell `at` towards smaller coordinates of `axis`.
  void add_face(std::size_t axis, const Cell& at) {
    Cell behind = at;
    --behind[axis];
    const Labels labels{region(behind), region(at)};
    const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
    for (long j = 0; j < k_; ++j)
      for (long i = 0; i < k_; ++i) {
        auto corner = [&](long du, long dv) {
          Cell key{at[0] * k_, at[1] * k_, at[2] * k_};
          key[u] += i + du;
          key[v] += j + dv;
          return vertex(key);
        };
        const std::array square{corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)};
        // Diagonals alternate, so that no direction is preferred.
        const std::size_t first = (i + j) % 2 == 0 ? 0 : 1;
        for (std::size_t half : {0, 2})
          mesh_.add_triangle(square[(first + half) % 4], square[(first + half + 1) % 4], square[(first + half + 2) % 4],
                             labels);
      }
  }

  Vertex vertex(const Cell& key) {
    const auto [it, fresh] = known_.try_emplace(key);
    if (fresh) {
      Vec3 x;
      for (std::size_t i = 0; i < 3; ++i)
        x[static_cast<int>(i)] =
            static_cast<double>(key[i]) / static_cast<double>(k_) - static_cast<double>(cells_[i]) / 2;
      it->second = mesh_.add_vertex(x);
    }
    return it->second;
  }

  Cell cells_;
  long k_;
  SurfaceMesh mesh_;
  std::map<Cell, Vertex> known_;
};

class TetrahedralBuilder {
 public:
  explicit TetrahedralBuilder(long k) : k_(k) {
    const double s = 1 / std::sqrt(3.0);
    cluster_.corners = {Vec3(s, s, s), Vec3(s, -s, -s), Vec3(-s, s, -s), Vec3(-s, -s, s)};
    Weights middle{};
    middle[centre] = k;
    cluster_.middle = vertex(middle);
  }

  TetrahedralCluster build() {
    for (std::size_t i = 0; i < 4; ++i) add_outer_film(i);
    for (std::size_t i = 0; i < 4; ++i)
      for (std::size_t j = i + 1; j < 4; ++j) add_inner_film(i, j);
    return std::move(cluster_);
  }

 private:
  // How much of the four corners and of the middle makes up a vertex; they add up to k.
  using Weights = std::array<long, 5>;
  static constexpr std::size_t centre = 4;
  using Corners = std::array<std::size_t, 3>;

  static Region opposite(std::size_t corner) { return Region(corner + 1); }

  void add_outer_film(std::size_t i) {
    const Corners c{(i + 1) % 4, (i + 2) % 4, (i + 3) % 4};
    const bool outwards = normal(c).dot(cluster_.corners[i]) < 0;
    const Labels labels{opposite(i), air};
    add_grid(c, outwards ? labels : labels.flipped());
  }

  void add_inner_film(std::size_t i, std::size_t j) {
    std::size_t m = 0;
    while (m == i || m == j) ++m;
    const std::size_t n = 6 - i - j - m;
    const Corners c{centre, i, j};
    // The bubble opposite to m lies on the side of corner n.
    const bool towards_n = normal(c).dot(cluster_.corners[n]) > 0;
    add_grid(c, towards_n ? Labels{opposite(n), opposite(m)} : Labels{opposite(m), opposite(n)});
  }

  Vec3 normal(const Corners& c) const {
    auto at = [this](std::size_t i) { return i == centre ? Vec3::Zero().eval() : cluster_.corners[i]; };
    return (at(c[1]) - at(c[0])).cross(at(c[2]) - at(c[0]));
  }

  void add_grid(const Corners& c, Labels labels) {
    auto at = [&](long a, long b, long d) {
      Weights w{};
      w[c[0]] += a, w[c[1]] += b, w[c[2]] += d;
      return vertex(w);
    };
    for (long a = 0; a < k_; ++a)
      for (long b = 0; a + b < k_; ++b) {
        const long d = k_ - 1 - a - b;
        cluster_.mesh.add_triangle(at(a + 1, b, d), at(a, b + 1, d), at(a, b, d + 1), labels);
        if (d > 0) cluster_.mesh.add_triangle(at(a, b + 1, d), at(a + 1, b, d), at(a + 1, b + 1, d - 1), labels);
      }
  }

  Vertex vertex(const Weights& w) {
    const auto [it, fresh] = known_.try_emplace(w);
    if (fresh) {
      Vec3 direction = Vec3::Zero();
      for (std::size_t i = 0; i < 4; ++i) direction += static_cast<double>(w[i]) * cluster_.corners[i];
      const double radius = 1 - static_cast<double>(w[centre]) / static_cast<double>(k_);
      it->second = cluster_.mesh.add_vertex(radius > 0 ? Vec3(radius * direction.normalized()) : Vec3::Zero());
    }
    return it->second;
  }

  long k_;
  TetrahedralCluster cluster_;
  std::map<Weights, Vertex> known_;
};

}  // namespace

SurfaceMesh block_of_cubes(const Cell& cells, long k) {
  if (cells[0] < 1 || cells[1] < 1 || cells[2] < 1 || k < 1)
    throw base::InputError("a block of cubes needs at least one cube and one square along each side");
  return BlockBuilder(cells, k).build();
}

TetrahedralCluster tetrahedral_cluster(long k) {
  if (k < 2) throw base::InputError("a tetrahedral cluster needs two or more triangles along each border");
  return TetrahedralBuilder(k).build();
}

}  // namespace foamsim
