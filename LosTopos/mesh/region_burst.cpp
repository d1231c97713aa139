#include "LosTopos/mesh/region_burst.h"

#include <algorithm>

#include "Base/lists/erase_repeated.h"
#include "LosTopos/error.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

bool separates(Labels labels, Region region) {
  return labels.has(region) && labels.has(air);
}

}  // namespace

bool has_film_to_air(const SurfaceMesh& mesh, Region region) {
  return region != air &&
         std::ranges::any_of(mesh.triangles(), [&](Triangle t) { return separates(mesh.labels(t), region); });
}

std::vector<Region> regions_at_air(const SurfaceMesh& mesh) {
  std::vector<Region> found;
  for (Triangle t : mesh.triangles()) {
    const Labels labels = mesh.labels(t);
    if (labels.has(air)) found.push_back(labels.p == air ? labels.q : labels.p);
  }
  base::sort_unique(found);
  return found;
}

Vec3 burst_region(SurfaceMesh& mesh, Region region) {
  if (region == air) throw base::InputError("region 0 is the air, which cannot burst");
  std::vector<Triangle> broken, opened;
  for (Triangle t : mesh.triangles())
    if (mesh.labels(t).has(region)) (mesh.labels(t).has(air) ? broken : opened).push_back(t);
  if (broken.empty()) return Vec3::Zero();
  Vec3 centre = Vec3::Zero();
  double broken_area = 0;
  std::vector<Vertex> corners_of_broken;
  for (Triangle t : broken) {
    const auto [a, b, c] = corners(mesh, t);
    centre += area(mesh, t) * (a + b + c) / 3;
    broken_area += area(mesh, t);
    corners_of_broken.insert(corners_of_broken.end(), mesh.vertices(t).begin(), mesh.vertices(t).end());
  }
  for (Triangle t : broken) mesh.remove_triangle(t);
  for (Triangle t : opened) {
    const Labels old = mesh.labels(t);
    mesh.set_labels(t, {old.p == region ? air : old.p, old.q == region ? air : old.q});
  }
  for (Vertex v : corners_of_broken)
    if (mesh.alive(v) && mesh.triangles(v).empty()) mesh.remove_vertex(v);
  return broken_area > 0 ? Vec3(centre / broken_area) : centre;
}

}  // namespace lostopos
