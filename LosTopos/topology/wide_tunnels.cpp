#include "LosTopos/topology/wide_tunnels.h"

#include <algorithm>
#include <vector>

#include "Base/lists/disjoint_sets.h"
#include "Base/lists/erase_repeated.h"

namespace lostopos {
namespace {

using Index = std::uint32_t;
constexpr Index none = RegionSurface::none;

// Sides around a vertex: a surface with a rim.
class Patch {
 public:
  Patch(const SurfaceMesh& mesh, const RegionSurface& surface)
      : mesh_(mesh), surface_(surface), place_(surface.size(), none) {}

  const std::vector<Index>& sides() const { return sides_; }

  // Those within the radius that sides within it join to the first; none where that reaches beyond it.
  void grow(Index first, const Vec3& centre, double radius) {
    for (Index s : sides_) place_[s] = none;
    sides_.clear();
    const auto take = [&](Index s) {
      if (place_[s] != none || !is_within(s, centre, radius)) return;
      place_[s] = static_cast<Index>(sides_.size());
      sides_.push_back(s);
    };
    take(first);
    for (std::size_t i = 0; i < sides_.size(); ++i)
      for (Index h = 3 * sides_[i]; h < 3 * sides_[i] + 3; ++h)
        if (surface_.across(h) != none) take(surface_.across(h) / 3);
  }

  // From vertices − edges + triangles = 2 − 2 genus − loops of the rim.
  double genus() const {
    if (sides_.empty()) return 0;
    base::DisjointSets corners(3 * sides_.size());
    double edges = 0;
    for (Index s : sides_) {
      for (Index h = 3 * s; h < 3 * s + 3; ++h) {
        edges += is_rim(h) ? 1 : 0.5;
        if (!is_rim(h))
          for (const auto& [a, b] : surface_.joined_corners(mesh_, h)) corners.unite(place(a), place(b));
      }
    }
    std::size_t vertices = 0;
    for (std::size_t c = 0; c < 3 * sides_.size(); ++c) vertices += corners.find(c) == c ? 1 : 0;
    return 1 - 0.5 * (static_cast<double>(vertices + sides_.size()) - edges + count_loops(corners));
  }

 private:
  // Of the rim; it goes through each of its vertices once.
  double count_loops(base::DisjointSets vertices) const {
    std::vector<std::size_t> at_rim;
    for (Index s : sides_) {
      for (Index h = 3 * s; h < 3 * s + 3; ++h) {
        if (!is_rim(h)) continue;
        const std::size_t a = place(3 * s + (h + 1) % 3), b = place(3 * s + (h + 2) % 3);
        vertices.unite(a, b);
        at_rim.push_back(a);
      }
    }
    for (std::size_t& c : at_rim) c = vertices.find(c);
    base::sort_unique(at_rim);
    return static_cast<double>(at_rim.size());
  }

  bool is_within(Index s, const Vec3& centre, double radius) const {
    return std::ranges::all_of(mesh_.vertices(surface_.triangle(s)),
                               [&](Vertex v) { return (mesh_.position(v) - centre).norm() <= radius; });
  }
  bool is_rim(Index h) const { return surface_.across(h) == none || place_[surface_.across(h) / 3] == none; }
  std::size_t place(std::size_t corner) const { return 3 * std::size_t{place_[corner / 3]} + corner % 3; }

  const SurfaceMesh& mesh_;
  const RegionSurface& surface_;
  std::vector<Index> sides_;
  std::vector<Index> place_;  // by side, among those of the patch
};

}  // namespace

double wide_tunnels(const SurfaceMesh& mesh, const RegionSurface& surface, const RegionSurface::Piece& piece,
                    double radius) {
  double left = piece.genus;
  std::vector<char> is_small(surface.size(), 0);  // has a part in a handle that was found
  std::vector<char> is_seen(surface.vertex_count(), 0);
  Patch patch(mesh, surface);
  for (Index s : piece.sides) {
    for (std::size_t k = 0; k < 3 && left > 0; ++k) {
      char& seen = is_seen[surface.vertex(3 * std::size_t{s} + k)];
      if (seen != 0) continue;
      seen = 1;
      patch.grow(s, mesh.position(mesh.vertices(surface.triangle(s))[k]), radius);
      if (std::ranges::any_of(patch.sides(), [&](Index other) { return is_small[other] != 0; })) continue;
      const double genus = patch.genus();
      if (!(genus > 0)) continue;
      left -= genus;
      for (Index other : patch.sides()) is_small[other] = 1;
    }
  }
  return left;
}

}  // namespace lostopos
