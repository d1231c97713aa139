#include "FoamSim/render/cut.h"

#include <array>
#include <cmath>
#include <map>
#include <utility>

#include "Base/error.h"

namespace foamsim::render {
namespace {

class Cut {
 public:
  Cut(const Surface& surface, const CutPlane& plane) : in_(surface) {
    out_.positions = in_.positions;
    for (const Eigen::Vector3d& x : in_.positions) over_.push_back(plane.normal.dot(x) - plane.offset);
    for (std::size_t t = 0; t < in_.triangles.size(); ++t) add(t);
    if (out_.triangles.empty()) throw base::InputError("nothing of the surface lies behind the cutting plane");
  }

  Surface take() { return std::move(out_); }

 private:
  bool behind(std::uint32_t v) const { return over_[v] <= 0; }

  // Where side ab meets the plane: one vertex for all triangles of the side.
  std::uint32_t crossing(std::uint32_t a, std::uint32_t b) {
    if (a > b) std::swap(a, b);
    const auto [place, is_new] = crossings_.try_emplace({a, b}, static_cast<std::uint32_t>(out_.positions.size()));
    if (is_new) {
      const double part = over_[a] / (over_[a] - over_[b]);
      out_.positions.push_back(in_.positions[a] + part * (in_.positions[b] - in_.positions[a]));
    }
    return place->second;
  }

  using Color = Eigen::Vector3f;
  using Colors = std::array<Color, 3>;

  void keep(std::size_t of, const std::array<std::uint32_t, 3>& corners, const Colors& colors) {
    out_.triangles.push_back(corners);
    out_.labels.push_back(in_.labels[of]);
    if (!in_.hidden.empty()) out_.hidden.push_back(in_.hidden[of]);
    if (!in_.colors.empty()) out_.colors.push_back(colors);
  }

  // Where side ab meets the plane.
  Color between(const Color& color_a, const Color& color_b, std::uint32_t a, std::uint32_t b) const {
    const auto part = static_cast<float>(over_[a] / (over_[a] - over_[b]));
    return color_a + part * (color_b - color_a);
  }

  void add(std::size_t t) {
    const auto& corners = in_.triangles[t];
    int kept = 0;
    for (const std::uint32_t v : corners) kept += behind(v) ? 1 : 0;
    const Colors colors = in_.colors.empty() ? Colors{Color::Zero(), Color::Zero(), Color::Zero()} : in_.colors[t];
    if (kept == 3) return keep(t, corners, colors);
    if (kept == 0) return;
    // The corner that is alone on its side, and the two others in their order.
    std::size_t k = 0;
    while (behind(corners[k]) != (kept == 1)) ++k;
    const std::uint32_t lone = corners[k], b = corners[(k + 1) % 3], c = corners[(k + 2) % 3];
    const std::uint32_t ab = crossing(lone, b), ca = crossing(c, lone);
    const Color &color_b = colors[(k + 1) % 3], &color_c = colors[(k + 2) % 3];
    const Color color_ab = between(colors[k], color_b, lone, b), color_ca = between(colors[k], color_c, lone, c);
    if (kept == 1) return keep(t, {lone, ab, ca}, {colors[k], color_ab, color_ca});
    keep(t, {ab, b, c}, {color_ab, color_b, color_c});
    keep(t, {ab, c, ca}, {color_ab, color_c, color_ca});
  }

  const Surface& in_;
  Surface out_;
  std::vector<double> over_;  // signed distance times the normal's length, by vertex
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> crossings_;
};

}  // namespace

Surface cut(const Surface& surface, const CutPlane& plane) {
  if (!plane.normal.allFinite() || plane.normal.isZero(0) || !std::isfinite(plane.offset))
    throw base::InputError("cutting plane: the normal has to be a direction, the offset a finite number");
  return Cut(surface, plane).take();
}

}  // namespace foamsim::render
