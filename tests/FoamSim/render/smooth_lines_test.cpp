#include "FoamSim/render/smooth_lines.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace foamsim::render {
namespace {

using Eigen::Vector3f;

TEST(SmoothLines, follow_a_circle_between_its_corners) {
  constexpr int corners = 12;
  std::vector<Segment> circle;
  circle.reserve(corners);
  const auto corner = [](int i) {
    const double angle = 2 * std::numbers::pi * (i % corners) / corners;
    return Vector3f(static_cast<float>(std::cos(angle)), static_cast<float>(std::sin(angle)), 0);
  };
  for (int i = 0; i < corners; ++i) circle.push_back({corner(i), corner(i + 1)});
  const std::vector<Segment> smooth = smooth_lines(circle, 4);
  ASSERT_EQ(smooth.size(), 48u);
  // The middles of the straight sides are 3.4% inside.
  for (const Segment& piece : smooth)
    for (const Vector3f& x : piece) EXPECT_NEAR(x.norm(), 1, 2e-3f);
  for (std::size_t i = 0; i < smooth.size(); ++i) EXPECT_EQ(smooth[i][1], smooth[(i + 1) % smooth.size()][0]);
}

TEST(SmoothLines, keep_corners_where_lines_bend_sharply_or_more_meet) {
  const Vector3f o(0, 0, 0), a(1, 0, 0), b(0, 1, 0), c(-1, 0.2f, 0);
  for (const std::vector<Segment>& lines :
       {std::vector<Segment>{{o, a}, {o, b}}, std::vector<Segment>{{o, a}, {o, b}, {c, o}}})
    for (const Segment& piece : smooth_lines(lines, 3)) {
      const Vector3f way = piece[1] - piece[0];
      const Vector3f line = piece[0].isZero() ? piece[1] : piece[0];
      EXPECT_NEAR(way.cross(line).norm(), 0, 1e-6f);  // along a straight line through the corner
    }
}

}  // namespace
}  // namespace foamsim::render
