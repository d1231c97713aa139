#include "LosTopos/topology/region_parts.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numbers>
#include <span>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/collision/broad_phase.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/topology/region_surface.h"
#include "LosTopos/topology/wide_tunnels.h"

namespace lostopos {
namespace {

// Walks over the boundaries of regions, each side of each triangle once.
class PartWalk {
 public:
  explicit PartWalk(const SurfaceMesh& mesh) : mesh_(mesh), seen_(2 * mesh.triangle_slots(), 0) {}

  bool is_new(Triangle t, Region r) const { return seen_[side(t, r)] == 0; }

  // Collects the part that t belongs to on its side towards r, and its box.
  Box collect(Triangle t, Region r, std::vector<Triangle>& boundary) {
    boundary.assign(1, t);
    seen_[side(t, r)] = 1;
    Box box = triangle_box(mesh_, t, mesh_.positions(), 0);
    for (std::size_t i = 0; i < boundary.size(); ++i) {
      for (Edge e : mesh_.edges(boundary[i])) {
        for (Triangle u : mesh_.triangles(e)) {
          if (!mesh_.labels(u).has(r) || seen_[side(u, r)] != 0) continue;
          seen_[side(u, r)] = 1;
          boundary.push_back(u);
          const Box of_triangle = triangle_box(mesh_, u, mesh_.positions(), 0);
          box = {box.low.cwiseMin(of_triangle.low), box.high.cwiseMax(of_triangle.high)};
        }
      }
    }
    return box;
  }

 private:
  std::size_t side(Triangle t, Region r) const { return 2 * t.index() + (mesh_.labels(t).p == r ? 0 : 1); }

  const SurfaceMesh& mesh_;
  std::vector<char> seen_;
};

// Positive when r is inside the closed boundary (six times the volume, L³).
double enclosed(const SurfaceMesh& mesh, std::span<const Triangle> boundary, Region r, const Vec3& origin) {
  double sum = 0;
  for (Triangle t : boundary) {
    const auto [a, b, c] = corners(mesh, t);
    const double volume = (a - origin).dot((b - origin).cross(Vec3(c - origin)));
    sum += mesh.labels(t).p == r ? volume : -volume;
  }
  return sum;
}

// Of the largest ball in a tetrahedron that encloses a sixth of `volume` (L).
double inscribed_diameter(const SurfaceMesh& mesh, std::span<const Triangle> boundary, double volume) {
  double whole_area = 0;
  for (Triangle t : boundary) whole_area += area(mesh, t);
  return volume / whole_area;
}

}  // namespace

RegionShape region_shape(const SurfaceMesh& mesh, Region region) {
  RegionShape shape;
  for (const RegionSurface::Piece& piece : RegionSurface(mesh, region).pieces(mesh)) {
    const bool is_pocket = piece.volume > 0;
    ++(is_pocket ? shape.pockets : shape.pieces);
    if (!is_pocket) shape.tunnels += piece.genus;
  }
  return shape;
}

bool surrounds_one_solid(const SurfaceMesh& mesh, Region region, const Openings& least) {
  const RegionSurface surface(mesh, region);
  const auto pieces = surface.pieces(mesh);
  const double smallest = std::numbers::pi / 6 * least.pocket * least.pocket * least.pocket;
  const auto counts = [&](const RegionSurface::Piece& piece) {
    return !(piece.volume >= 0 && piece.volume < smallest);
  };
  if (std::ranges::count_if(pieces, counts) != 1) return false;
  const RegionSurface::Piece& outside = *std::ranges::find_if(pieces, counts);
  return outside.volume < 0 && outside.closed && wide_tunnels(mesh, surface, outside, least.tunnel) == 0;
}

std::vector<RegionPart> small_region_parts(const SurfaceMesh& mesh, const SmallParts& small) {
  std::vector<RegionPart> parts;
  PartWalk walk(mesh);
  std::vector<Triangle> boundary;
  for (Triangle t : mesh.triangles()) {
    const Labels labels = mesh.labels(t);
    for (Region r : {labels.p, labels.q}) {
      if (!walk.is_new(t, r)) continue;
      const Box box = walk.collect(t, r, boundary);
      const bool is_short = (box.high - box.low).norm() < small.diagonal;
      if (!is_short && boundary.size() != 4) continue;
      RegionPart part{r, boundary, {}, 0.5 * (box.low + box.high)};
      const double volume = enclosed(mesh, boundary, r, part.centre);
      // Seen from outside, a bubble's boundary is one of the region around it: that one is not small.
      if (!(volume > 0)) continue;
      if (!is_short && !(inscribed_diameter(mesh, boundary, volume) < small.thickness)) continue;
      std::ranges::sort(part.boundary);
      for (Triangle u : boundary)
        part.neighbours.push_back(mesh.labels(u).p == r ? mesh.labels(u).q : mesh.labels(u).p);
      base::sort_unique(part.neighbours);
      parts.push_back(std::move(part));
    }
  }
  return parts;
}

}  // namespace lostopos
