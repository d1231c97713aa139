#include "LosTopos/mesh/region_lines.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

constexpr int most_probes = 4;           // lines through one part of the surface
constexpr double clear_of_edges = 1e-9;  // to an edge, as a barycentric coordinate
constexpr double same_depth = 1e-12;     // of two films on a line, over the extent

// A triangle seen along the lines: its corners across and along them.
struct FilmShadow {
  Triangle triangle;
  std::size_t part = 0;
  std::array<Eigen::Vector2d, 3> across;
  std::array<double, 3> along;
  double twice_area = 0;  // signed: positive where the lines go through from p to q
};

struct FilmCrossing {
  double place = 0;
  Triangle triangle;
  Region before, after;
};

struct ProbeLine {
  Eigen::Vector2d across;
  bool unclear = false;
  std::vector<FilmCrossing> crossings = {};
};

double planar_cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

// Vertices that edges join have one number; the smallest vertex of each part.
std::vector<std::uint32_t> parts_of_vertices(const SurfaceMesh& mesh) {
  std::vector<std::uint32_t> parent(mesh.vertex_slots());
  std::iota(parent.begin(), parent.end(), 0U);
  const auto root = [&](std::uint32_t v) {
    while (parent[v] != v) v = parent[v] = parent[parent[v]];
    return v;
  };
  for (Edge e : mesh.edges()) {
    const std::uint32_t a = root(mesh.vertices(e)[0].index()), b = root(mesh.vertices(e)[1].index());
    parent[std::max(a, b)] = std::min(a, b);
  }
  for (std::uint32_t v = 0; v < parent.size(); ++v) parent[v] = root(v);
  return parent;
}

class LineSearch {
 public:
  LineSearch(const SurfaceMesh& mesh, bool whole, std::size_t limit) : mesh_(mesh), whole_(whole), limit_(limit) {
    cast_shadows();
  }

  std::vector<std::string> run() {
    std::vector<std::size_t> parts(first_.size() - 1);
    std::iota(parts.begin(), parts.end(), std::size_t{0});
    for (int attempt = 0; attempt < most_probes && !parts.empty(); ++attempt) {
      std::vector<ProbeLine> lines = lines_through(parts, static_cast<std::size_t>(attempt));
      trace(lines);
      std::vector<std::size_t> again;
      for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].unclear)
          again.push_back(parts[i]);
        else
          judge(lines[i]);
      }
      parts = std::move(again);
    }
    return std::move(messages_);
  }

 private:
  void cast_shadows() {
    // No direction that meshes are likely to have edges along.
    const Vec3 direction = Vec3(0.5403, 0.6177, 0.5714).normalized();
    const Vec3 u = direction.unitOrthogonal(), w = direction.cross(u);
    const std::vector<std::uint32_t> part = parts_of_vertices(mesh_);
    for (Triangle t : mesh_.triangles()) {
      const auto at = corners(mesh_, t);
      FilmShadow s{t, part[mesh_.vertices(t)[0].index()], {}, {}};
      for (std::size_t i = 0; i < 3; ++i) {
        s.across[i] = {at[i].dot(u), at[i].dot(w)};
        s.along[i] = at[i].dot(direction);
        extent_ = std::max(extent_, at[i].cwiseAbs().maxCoeff());
      }
      s.twice_area = planar_cross(s.across[1] - s.across[0], s.across[2] - s.across[0]);
      air_occurs_ = air_occurs_ || mesh_.labels(t).has(air);
      shadows_.push_back(s);
    }
    // The widest shadows of each part first: lines through them are the clearest.
    std::ranges::stable_sort(shadows_, [](const FilmShadow& a, const FilmShadow& b) {
      return a.part != b.part ? a.part < b.part : std::abs(a.twice_area) > std::abs(b.twice_area);
    });
    for (std::size_t i = 0; i < shadows_.size(); ++i)
      if (i == 0 || shadows_[i].part != shadows_[i - 1].part) first_.push_back(i);
    first_.push_back(shadows_.size());
  }

  std::vector<ProbeLine> lines_through(const std::vector<std::size_t>& parts, std::size_t attempt) const {
    std::vector<ProbeLine> lines;
    lines.reserve(parts.size());
    for (std::size_t part : parts) {
      const std::size_t here = std::min(first_[part] + attempt, first_[part + 1] - 1);
      const auto& c = shadows_[here].across;
      lines.push_back({.across = (c[0] + c[1] + c[2]) / 3});
    }
    return lines;
  }

  void trace(std::vector<ProbeLine>& lines) const {
    std::vector<ProbeLine*> sorted;
    sorted.reserve(lines.size());
    for (ProbeLine& line : lines) sorted.push_back(&line);
    std::ranges::stable_sort(sorted, {}, [](const ProbeLine* line) { return line->across.x(); });
    for (const FilmShadow& s : shadows_) {
      const auto [low, high] = std::minmax({s.across[0].x(), s.across[1].x(), s.across[2].x()});
      auto it = std::ranges::lower_bound(sorted, low, {}, [](const ProbeLine* line) { return line->across.x(); });
      for (; it != sorted.end() && (*it)->across.x() <= high; ++it) cross_one(s, **it);
    }
    for (ProbeLine& line : lines) {
      std::ranges::stable_sort(line.crossings, {}, &FilmCrossing::place);
      for (std::size_t i = 1; i < line.crossings.size(); ++i)
        if (line.crossings[i].place - line.crossings[i - 1].place <= same_depth * extent_) line.unclear = true;
    }
  }

  void cross_one(const FilmShadow& s, ProbeLine& line) const {
    std::array<double, 3> weight;
    for (std::size_t i = 0; i < 3; ++i) {
      const Eigen::Vector2d b = s.across[(i + 1) % 3] - line.across, c = s.across[(i + 2) % 3] - line.across;
      weight[i] = planar_cross(b, c) / s.twice_area;
    }
    const double least = std::ranges::min(weight);
    if (least < -clear_of_edges) return;
    if (!(least > clear_of_edges)) {  // so it is, too, for a triangle that is seen edge-on
      line.unclear = true;
      return;
    }
    const Labels labels = s.twice_area > 0 ? mesh_.labels(s.triangle) : mesh_.labels(s.triangle).flipped();
    line.crossings.push_back(
        {weight[0] * s.along[0] + weight[1] * s.along[1] + weight[2] * s.along[2], s.triangle, labels.p, labels.q});
  }

  void judge(const ProbeLine& line) {
    for (std::size_t i = 1; i < line.crossings.size(); ++i) {
      const FilmCrossing &from = line.crossings[i - 1], &to = line.crossings[i];
      if (from.after != to.before)
        say("from triangle " + std::to_string(from.triangle.index()) + " to triangle " +
            std::to_string(to.triangle.index()) + " region " + std::to_string(from.after.index()) +
            " turns into region " + std::to_string(to.before.index()) + " with no film between them");
    }
    if (!whole_ || line.crossings.empty()) return;
    judge_outermost(line.crossings.front().before, line.crossings.front().triangle);
    judge_outermost(line.crossings.back().after, line.crossings.back().triangle);
  }

  void judge_outermost(Region region, Triangle t) {
    if (!outermost_) outermost_ = air_occurs_ ? air : region;
    if (region == *outermost_) return;
    say("outside of triangle " + std::to_string(t.index()) + ", the outermost there, is region " +
        std::to_string(region.index()) + ", not " + (*outermost_ == air ? "the open air " : "region ") +
        std::to_string(outermost_->index()) + ": its bubble is inside out");
  }

  void say(std::string message) {
    if (messages_.size() < limit_) messages_.push_back(std::move(message));
  }

  const SurfaceMesh& mesh_;
  bool whole_;
  std::size_t limit_;
  std::vector<FilmShadow> shadows_;
  std::vector<std::size_t> first_;  // shadow of each part, and their number
  double extent_ = 0;
  bool air_occurs_ = false;
  std::optional<Region> outermost_;
  std::vector<std::string> messages_;
};

}  // namespace

std::vector<std::string> contradictions_on_lines(const SurfaceMesh& mesh, bool whole, std::size_t limit) {
  return LineSearch(mesh, whole, limit).run();
}

}  // namespace lostopos
