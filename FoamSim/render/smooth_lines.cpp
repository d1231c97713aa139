#include "FoamSim/render/smooth_lines.h"

#include <array>
#include <map>

namespace foamsim::render {
namespace {

using Eigen::Vector3f;

using Key = std::array<float, 3>;

Key key_of(const Vector3f& x) {
  return {x.x(), x.y(), x.z()};
}

// The other ends of the segments that end in a point.
using Ends = std::map<Key, std::vector<Vector3f>>;

Ends ends_of(const std::vector<Segment>& segments) {
  Ends ends;
  for (const Segment& segment : segments) {
    ends[key_of(segment[0])].push_back(segment[1]);
    ends[key_of(segment[1])].push_back(segment[0]);
  }
  return ends;
}

// Of the curve at `at`, on its way towards `next`, as long as the segment between them.
Vector3f tangent(const Ends& ends, const Vector3f& at, const Vector3f& next) {
  constexpr float smallest_cosine = 0.5f;
  Vector3f straight = next - at;
  const std::vector<Vector3f>& others = ends.at(key_of(at));
  if (others.size() != 2) return straight;
  const Vector3f before = at - (others[0] == next ? others[1] : others[0]);
  const float cosine = before.normalized().dot(straight.normalized());
  if (!(cosine > smallest_cosine)) return straight;
  // The nearer neighbour says more of the direction: weights that make it exact on circles.
  const Vector3f direction = before / before.squaredNorm() + straight / straight.squaredNorm();
  return straight.norm() * direction.normalized();
}

}  // namespace

std::vector<Segment> smooth_lines(const std::vector<Segment>& segments, int parts) {
  const Ends ends = ends_of(segments);
  std::vector<Segment> pieces;
  pieces.reserve(segments.size() * static_cast<std::size_t>(parts));
  for (const auto& [a, b] : segments) {
    const Vector3f from = tangent(ends, a, b), to = -tangent(ends, b, a);
    Vector3f last = a;
    for (int i = 1; i <= parts; ++i) {
      const float t = static_cast<float>(i) / static_cast<float>(parts);
      const float t2 = t * t, t3 = t2 * t;
      const Vector3f next =
          i == parts
              ? b
              : Vector3f((2 * t3 - 3 * t2 + 1) * a + (t3 - 2 * t2 + t) * from + (3 * t2 - 2 * t3) * b + (t3 - t2) * to);
      pieces.push_back({last, next});
      last = next;
    }
  }
  return pieces;
}

}  // namespace foamsim::render
