#include "FoamSim/scenes/shapes/pulling_rings.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <vector>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/edge_distance.h"
#include "FoamSim/scenes/shapes/held.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

// Moves the vertices to the circle that fits them best.
void round_off(SurfaceMesh& mesh, const std::vector<Vertex>& ring) {
  const auto count = static_cast<double>(ring.size());
  Vec3 centre = Vec3::Zero();
  for (Vertex v : ring) centre += mesh.position(v) / count;
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  double radius = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec3 a = mesh.position(ring[i]) - centre;
    radius += a.norm() / count;
    for (std::size_t j = i + 1; j < ring.size(); ++j) {
      const Vec3 n = a.cross(Vec3(mesh.position(ring[j]) - centre));
      spread += n * n.transpose();
    }
  }
  const Vec3 normal = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors().col(2);
  for (Vertex v : ring) {
    Vec3 out = mesh.position(v) - centre;
    out -= normal.dot(out) * normal;
    if (!(out.norm() > 0)) throw base::InputError("a ring to pull the foam by has a vertex in its middle");
    mesh.set_position(v, centre + radius * out.normalized());
  }
}

}  // namespace

void hold_by_rings(SurfaceMesh& mesh) {
  if (mesh.vertex_count() == 0) throw base::InputError("there is no foam to be pulled: the mesh is empty");
  for (Vertex v : mesh.vertices()) {
    const Vec3 x = mesh.position(v);
    mesh.set_position(v, {x.z(), x.y(), -x.x()});
  }
  const auto x_of = [&mesh](Vertex v) { return mesh.position(v).x(); };
  const std::vector<Vertex> all(mesh.vertices().begin(), mesh.vertices().end());
  const auto [least, greatest] = std::ranges::minmax_element(all, {}, x_of);
  std::vector<std::vector<Vertex>> rings;
  for (Vertex v : {*least, *greatest}) {
    rings.push_back(at_edge_distance(mesh, v, 2));
    if (rings.back().size() < 3) throw base::InputError("the foam is too coarse to be pulled by rings of its vertices");
  }
  std::vector<Vertex> held = rings[0];
  held.insert(held.end(), rings[1].begin(), rings[1].end());
  std::ranges::sort(held, {}, &Vertex::index);
  if (std::ranges::adjacent_find(held) != held.end())
    throw base::InputError("the foam is too coarse to be pulled: the two rings to pull it by have a vertex in common");
  for (const std::vector<Vertex>& ring : rings) round_off(mesh, ring);
  mark_held(mesh, held);
}

}  // namespace foamsim
