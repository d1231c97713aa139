#include "FoamSim/statistics/bubble_pressures.h"

#include <algorithm>
#include <vector>

#include "FoamSim/sheet/area_gradient.h"
#include "FoamSim/sheet/bubble_volumes.h"
#include "FoamSim/sheet/surface_geometry.h"

namespace foamsim {

using lostopos::Edge;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

std::vector<char> held_vertices(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  std::vector<char> held(mesh.vertex_slots(), 0);
  for (Edge e : mesh.edges())
    if (mesh.triangles(e).size() == 1)
      for (Vertex v : mesh.vertices(e)) held[v.index()] = 1;
  for (Triangle t : mesh.triangles())
    if (is_solid(t, solid))
      for (Vertex v : mesh.vertices(t)) held[v.index()] = 1;
  return held;
}

}  // namespace

std::map<Region, double> bubbles_of_films(const SurfaceMesh& mesh, std::span<const std::uint8_t> solid) {
  std::map<Region, double> bubbles = closed_bubbles(mesh);
  for (Triangle t : mesh.triangles())
    if (is_solid(t, solid))
      for (Region r : {mesh.labels(t).p, mesh.labels(t).q}) bubbles.erase(r);
  return bubbles;
}

std::map<Region, double> bubble_pressures(const SurfaceMesh& mesh, const std::map<Region, double>& bubbles,
                                          std::span<const std::uint8_t> solid) {
  if (bubbles.empty()) return {};
  const std::vector<char> held = held_vertices(mesh, solid);
  BubbleVolumes volumes(mesh, bubbles);
  if (!volumes.update(mesh.positions(), [&held](Vertex v) { return held[v.index()] == 0; })) return {};
  std::vector<Vec3> pull(mesh.vertex_slots(), Vec3::Zero());
  add_area_gradient(mesh, solid, mesh.positions(), 1, pull);
  const Eigen::VectorXd found = volumes.solve(volumes.product(pull));
  std::map<Region, double> pressures;
  Eigen::Index row = 0;
  if (found.size() == volumes.rows())
    for (const auto& [region, volume] : bubbles) pressures[region] = found[row++];
  return pressures;
}

}  // namespace foamsim
