#include "LosTopos/shapes/film_polygons.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <optional>
#include <set>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/shapes/indexed_surface.h"

namespace lostopos {
namespace {

using Side = std::pair<std::size_t, std::size_t>;

bool has_corner(const FilmPolygon& film, std::size_t corner) {
  return std::find(film.corners.begin(), film.corners.end(), corner) != film.corners.end();
}

std::vector<std::size_t> renamed(std::vector<std::size_t> corners, std::size_t from, std::size_t to) {
  std::replace(corners.begin(), corners.end(), from, to);
  base::erase_repeated(corners);
  if (corners.size() > 1 && corners.front() == corners.back()) corners.pop_back();
  return corners;
}

std::size_t distinct(std::vector<std::size_t> corners) {
  std::sort(corners.begin(), corners.end());
  return static_cast<std::size_t>(std::unique(corners.begin(), corners.end()) - corners.begin());
}

std::size_t common_corners(const FilmPolygon& film, const std::vector<std::size_t>& corners) {
  return static_cast<std::size_t>(
      std::count_if(corners.begin(), corners.end(), [&](std::size_t c) { return has_corner(film, c); }));
}

// The contraction of a side, shortest sides first.
class SideContraction {
 public:
  SideContraction(FilmPolygons foam, double shortest) : foam_(std::move(foam)), shortest_(shortest) {}

  // Every round takes a corner or gives up a side: bounded by the number of both.
  FilmPolygons run() {
    while (const std::optional<Side> side = shortest_side()) {
      if (is_allowed(*side))
        contract(*side);
      else
        kept_.insert(*side);
    }
    std::erase_if(foam_.films, [](const FilmPolygon& film) { return film.corners.size() < 3; });
    return std::move(foam_);
  }

 private:
  std::optional<Side> shortest_side() const {
    double least = shortest_;
    std::optional<Side> found;
    for (const FilmPolygon& film : foam_.films) {
      for (std::size_t i = 0; i < film.corners.size() && film.corners.size() > 2; ++i) {
        const Side side = std::minmax({film.corners[i], film.corners[(i + 1) % film.corners.size()]});
        const double length = (foam_.corners[side.first].position - foam_.corners[side.second].position).norm();
        if (length >= least || kept_.contains(side)) continue;
        least = length;
        found = side;
      }
    }
    return found;
  }

  bool is_allowed(Side side) const {
    std::vector<FilmPolygon> changed;
    for (const FilmPolygon& film : foam_.films) {
      if (!has_corner(film, side.first) && !has_corner(film, side.second)) continue;
      FilmPolygon after{renamed(film.corners, side.second, side.first), film.labels};
      if (after.corners.size() < 3) continue;
      if (distinct(after.corners) < after.corners.size()) return false;
      changed.push_back(std::move(after));
    }
    for (std::size_t i = 0; i < changed.size(); ++i) {
      for (std::size_t j = 0; j < i; ++j) {
        const std::size_t common = common_corners(changed[i], changed[j].corners);
        if (common > 2 && common == std::min(changed[i].corners.size(), changed[j].corners.size())) return false;
      }
    }
    return true;
  }

  void contract(Side side) {
    for (FilmPolygon& film : foam_.films) film.corners = renamed(std::move(film.corners), side.second, side.first);
    FilmPolygons::Corner& to = foam_.corners[side.first];
    const FilmPolygons::Corner& from = foam_.corners[side.second];
    for (std::size_t k = 0; k < 3; ++k) {
      const auto i = static_cast<Eigen::Index>(k);
      if (from.fixed[k])
        to.position[i] = from.position[i];
      else if (!to.fixed[k])
        to.position[i] = (to.position[i] + from.position[i]) / 2;
      to.fixed[k] = to.fixed[k] || from.fixed[k];
    }
  }

  FilmPolygons foam_;
  double shortest_;
  std::set<Side> kept_;
};

// Relative to a corner, so that in a wall across an axis it stays in the wall to the bit.
Vec3 centre_of_area(const std::vector<Vec3>& corners) {
  Vec3 weighted = Vec3::Zero();
  double area = 0;
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    const Vec3 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
    const double part = a.cross(b).norm();
    weighted += part * (a + b) / 3;
    area += part;
  }
  return corners[0] + weighted / area;
}

struct LabelledSurface {
  IndexedSurface surface;
  std::vector<Labels> labels;
};

void add_fan(LabelledSurface& to, const FilmPolygon& film, const std::vector<std::uint32_t>& points) {
  IndexedSurface& surface = to.surface;
  auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    surface.triangles.push_back({a, b, c});
    to.labels.push_back(film.labels);
  };
  if (points.size() == 3) return add(points[0], points[1], points[2]);
  std::vector<Vec3> corners;
  corners.reserve(points.size());
  for (std::uint32_t point : points) corners.push_back(surface.points[point]);
  const auto centre = static_cast<std::uint32_t>(surface.points.size());
  surface.points.push_back(centre_of_area(corners));
  for (std::size_t i = 0; i < points.size(); ++i) add(points[i], points[(i + 1) % points.size()], centre);
}

}  // namespace

FilmPolygons without_short_sides(FilmPolygons foam, double shortest) {
  return SideContraction(std::move(foam), shortest).run();
}

SurfaceMesh triangulated(const FilmPolygons& foam, long subdivisions) {
  constexpr std::uint32_t unused = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> point_of(foam.corners.size(), unused);
  LabelledSurface coarse;
  for (const FilmPolygon& film : foam.films) {
    std::vector<std::uint32_t> points;
    for (std::size_t corner : film.corners) {
      if (point_of[corner] == unused) {
        point_of[corner] = static_cast<std::uint32_t>(coarse.surface.points.size());
        coarse.surface.points.push_back(foam.corners[corner].position);
      }
      points.push_back(point_of[corner]);
    }
    add_fan(coarse, film, points);
  }
  const std::size_t coarse_count = coarse.surface.triangles.size();
  const IndexedSurface fine = subdivided(std::move(coarse.surface), subdivisions);
  const std::size_t children = coarse_count == 0 ? 1 : fine.triangles.size() / coarse_count;
  SurfaceMesh mesh;
  mesh.reserve(fine.points.size(), fine.triangles.size());
  for (const Vec3& x : fine.points) mesh.add_vertex(x);
  for (std::size_t i = 0; i < fine.triangles.size(); ++i) {
    const auto& [a, b, c] = fine.triangles[i];
    mesh.add_triangle(Vertex(a), Vertex(b), Vertex(c), coarse.labels[i / children]);
  }
  return mesh;
}

}  // namespace lostopos
