#include "FoamSim/render/film_mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <tuple>

#include "Base/error.h"
#include "FoamSim/render/thickness.h"

namespace foamsim::render {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3f;

void check(const Surface& s) {
  const std::size_t n = s.triangles.size();
  if (n == 0) throw base::InputError("render: the surface has no triangles");
  const auto fits = [n](std::size_t count) { return count == 0 || count == n; };
  if (s.labels.size() != n || !fits(s.hidden.size()) || !fits(s.colors.size())) {
    throw base::InputError("render: " + std::to_string(n) + " triangles, but " + std::to_string(s.labels.size()) +
                           " labels, " + std::to_string(s.hidden.size()) + " hidden flags (may be 0) and " +
                           std::to_string(s.colors.size()) + " colours (may be 0); the numbers must agree");
  }
  for (std::size_t t = 0; t < n; ++t) {
    for (const std::uint32_t v : s.triangles[t]) {
      if (v < s.positions.size()) continue;
      throw base::InputError("render: triangle " + std::to_string(t) + " has vertex " + std::to_string(v) +
                             ", but there are only " + std::to_string(s.positions.size()) + " vertices");
    }
  }
  for (std::size_t v = 0; v < s.positions.size(); ++v)
    if (!s.positions[v].allFinite()) throw base::InputError("render: vertex " + std::to_string(v) + " is not finite");
}

// A side of a visible triangle; sorting brings the sides of one edge together.
struct Side {
  std::uint32_t low, high;  // vertices of the edge
  std::uint32_t triangle;   // in the surface

  bool same_edge(const Side& o) const { return low == o.low && high == o.high; }
  bool operator<(const Side& o) const { return std::tie(low, high, triangle) < std::tie(o.low, o.high, o.triangle); }
};

class Preparation {
 public:
  Preparation(const Surface& surface, const Vector3d& origin, double scale) : in_(surface) {
    out_.positions.reserve(in_.positions.size());
    for (const Vector3d& x : in_.positions) out_.positions.push_back(((x - origin) / scale).cast<float>());
    measure();
    collect_sides();
    parent_.resize(3 * in_.triangles.size());
    std::iota(parent_.begin(), parent_.end(), 0u);
    for (std::size_t i = 0; i < sides_.size();) {
      std::size_t end = i + 1;
      while (end < sides_.size() && sides_[end].same_edge(sides_[i])) ++end;
      edge(i, end);
      i = end;
    }
    if (edges_ > 0) out_.mean_edge = static_cast<float>(length_ / static_cast<double>(edges_) / scale);
    write_triangles();
  }

  FilmMesh take() { return std::move(out_); }

 private:
  bool visible(std::size_t t) const { return in_.hidden.empty() || in_.hidden[t] == 0; }
  bool flat(std::size_t t) const { return normals_[t].isZero(0); }
  const Vector3d& point(std::uint32_t v) const { return in_.positions[v]; }

  std::pair<std::int32_t, std::int32_t> pair(std::size_t t) const {
    return std::minmax(in_.labels[t][0], in_.labels[t][1]);
  }

  // +1 or −1: turns the triangle's normal to point from the lower region to the higher.
  double sign(std::size_t t) const { return in_.labels[t][0] <= in_.labels[t][1] ? 1 : -1; }

  // Unit normals; zero for triangles whose height is below rounding error of their length.
  void measure() {
    normals_.assign(in_.triangles.size(), Vector3d::Zero());
    for (std::size_t t = 0; t < in_.triangles.size(); ++t) {
      const auto& [a, b, c] = in_.triangles[t];
      const Vector3d ab = point(b) - point(a);
      const Vector3d ac = point(c) - point(a);
      const double longest = std::max({ab.stableNorm(), ac.stableNorm(), (point(c) - point(b)).stableNorm()});
      if (!(longest > 0)) continue;
      const Vector3d cross = (ab / longest).cross(ac / longest);
      if (cross.norm() > 1e-10) normals_[t] = cross.normalized();
    }
  }

  // Triangles of zero area count here, so that the gap they leave is not taken for a free edge.
  void collect_sides() {
    for (std::size_t t = 0; t < in_.triangles.size(); ++t) {
      const auto& c = in_.triangles[t];
      if (!visible(t) || c[0] == c[1] || c[1] == c[2] || c[2] == c[0]) continue;
      for (int i = 0; i < 3; ++i) {
        const auto [low, high] = std::minmax(c[i], c[(i + 1) % 3]);
        sides_.push_back({low, high, static_cast<std::uint32_t>(t)});
      }
    }
    std::sort(sides_.begin(), sides_.end());
  }

  void edge(std::size_t begin, std::size_t end) {
    const Side& side = sides_[begin];
    length_ += (point(side.high) - point(side.low)).stableNorm();
    ++edges_;
    const Segment segment{out_.positions[side.low], out_.positions[side.high]};
    if (end - begin == 1) out_.rims.push_back(segment);
    // Films of bubbles that were taken apart; at a solid, which is hidden, they only end.
    const bool between_films =
        in_.hidden.empty() && end - begin == 2 && pair(side.triangle) != pair(sides_[begin + 1].triangle);
    if (end - begin >= 3 || between_films) out_.borders.push_back(segment);
    if (end - begin == 2) join(side.triangle, sides_[begin + 1].triangle, side);
  }

  // Lets two triangles of a film share their normals at both ends of their edge.
  void join(std::uint32_t s, std::uint32_t t, const Side& side) {
    constexpr double kCreaseCosine = 0.5;
    if (pair(s) != pair(t)) return;
    if (!(sign(s) * sign(t) * normals_[s].dot(normals_[t]) > kCreaseCosine)) return;
    for (const std::uint32_t v : {side.low, side.high}) parent_[find(corner(s, v))] = find(corner(t, v));
  }

  std::uint32_t corner(std::uint32_t t, std::uint32_t v) const {
    const auto& c = in_.triangles[t];
    return 3 * t + (c[0] == v ? 0 : c[1] == v ? 1 : 2);
  }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }

  double angle(std::size_t t, int i) const {
    const auto& c = in_.triangles[t];
    const Vector3d a = (point(c[(i + 1) % 3]) - point(c[i])).stableNormalized();
    const Vector3d b = (point(c[(i + 2) % 3]) - point(c[i])).stableNormalized();
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  void write_triangles() {
    std::vector<Vector3d> sums(parent_.size(), Vector3d::Zero());
    for (std::size_t t = 0; t < in_.triangles.size(); ++t) {
      if (!visible(t) || flat(t)) continue;
      for (int i = 0; i < 3; ++i) sums[find(3 * t + i)] += sign(t) * angle(t, i) * normals_[t];
    }
    for (std::size_t t = 0; t < in_.triangles.size(); ++t) {
      if (!visible(t) || flat(t)) continue;
      out_.triangles.push_back(in_.triangles[t]);
      out_.face_normals.push_back(normals_[t].cast<float>());
      auto& corners = out_.corner_normals.emplace_back();
      for (int i = 0; i < 3; ++i) {
        const Vector3d sum = sign(t) * sums[find(3 * t + i)];
        // Corners joined all the way round a spiky vertex can still disagree; the face's own normal is then the best
        // there is.
        const bool usable = sum.dot(normals_[t]) > 0;
        corners[i] = (usable ? sum.normalized() : normals_[t]).cast<float>();
      }
      if (!in_.colors.empty()) out_.corner_colors.push_back(in_.colors[t]);
      const auto [p, q] = pair(t);
      out_.films.push_back(hash(static_cast<std::uint32_t>(p) + hash(static_cast<std::uint32_t>(q))));
    }
  }

  const Surface& in_;
  FilmMesh out_;
  std::vector<Vector3d> normals_;
  std::vector<Side> sides_;
  std::vector<std::uint32_t> parent_;  // union-find over corners 3 t + i
  double length_ = 0;
  std::size_t edges_ = 0;
};

}  // namespace

FilmMesh prepare(const Surface& surface, const Vector3d& origin, double scale) {
  check(surface);
  return Preparation(surface, origin, scale).take();
}

}  // namespace foamsim::render
