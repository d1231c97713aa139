#include "FoamSim/constraints/wire_groups.h"

#include <algorithm>

#include "Base/error.h"

namespace foamsim {

using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

constexpr int unseen = -1;

// The number of the piece that each vertex is in; pieces are joined by edges between the vertices.
std::vector<int> pieces_of(const SurfaceMesh& mesh, const std::vector<Vertex>& vertices) {
  std::vector<int> place(mesh.vertex_slots(), unseen), piece(vertices.size(), unseen);
  for (std::size_t i = 0; i < vertices.size(); ++i) place[vertices[i].index()] = static_cast<int>(i);
  int count = 0;
  for (std::size_t first = 0; first < vertices.size(); ++first) {
    if (piece[first] != unseen) continue;
    std::vector<std::size_t> waiting{first};
    piece[first] = count;
    while (!waiting.empty()) {
      const Vertex v = vertices[waiting.back()];
      waiting.pop_back();
      for (lostopos::Edge e : mesh.edges(v)) {
        const int other = place[mesh.other_vertex(e, v).index()];
        if (other == unseen || piece[static_cast<std::size_t>(other)] != unseen) continue;
        piece[static_cast<std::size_t>(other)] = count;
        waiting.push_back(static_cast<std::size_t>(other));
      }
    }
    ++count;
  }
  return piece;
}

Vec3 farthest_direction(const SurfaceMesh& mesh, const std::vector<Vertex>& vertices) {
  Vec3 low = mesh.position(vertices[0]), high = low;
  for (Vertex v : vertices) {
    low = low.cwiseMin(mesh.position(v));
    high = high.cwiseMax(mesh.position(v));
  }
  Eigen::Index coordinate = 0;
  (high - low).maxCoeff(&coordinate);
  return Vec3::Unit(coordinate);
}

std::vector<char> parted_in_the_middle(const SurfaceMesh& mesh, const std::vector<Vertex>& vertices,
                                       const Vec3& along) {
  std::vector<double> at;
  at.reserve(vertices.size());
  for (Vertex v : vertices) at.push_back(along.dot(mesh.position(v)));
  const auto [low, high] = std::ranges::minmax(at);
  std::vector<char> second;
  second.reserve(at.size());
  for (double value : at) second.push_back(value > (low + high) / 2 ? 1 : 0);
  return second;
}

Vec3 mean_of(const SurfaceMesh& mesh, const std::vector<Vertex>& vertices, const std::vector<char>& second,
             char group) {
  Vec3 sum = Vec3::Zero();
  double count = 0;
  for (std::size_t i = 0; i < vertices.size(); ++i)
    if (second[i] == group) {
      sum += mesh.position(vertices[i]);
      ++count;
    }
  return sum / count;
}

}  // namespace

WireGroups part_groups(const SurfaceMesh& mesh, const WireSpec& wire, const std::vector<Vertex>& vertices) {
  WireGroups groups;
  if (wire.motion.axis) {
    groups.second = parted_in_the_middle(mesh, vertices, *wire.motion.axis);
  } else {
    const std::vector<int> pieces = pieces_of(mesh, vertices);
    if (*std::ranges::max_element(pieces) == 1)
      groups.second.assign(pieces.begin(), pieces.end());
    else
      groups.second = parted_in_the_middle(mesh, vertices, farthest_direction(mesh, vertices));
  }
  const auto in_second = std::ranges::count(groups.second, 1);
  const Vec3 between =
      in_second == 0 ? Vec3(Vec3::Zero())
                     : Vec3(mean_of(mesh, vertices, groups.second, 1) - mean_of(mesh, vertices, groups.second, 0));
  if (!(between.norm() > 0))
    throw base::InputError("the wire '" + wire.text() +
                           "' has no two groups that could go apart; 'pull' needs vertices in two places");
  groups.axis = wire.motion.axis.value_or(between.normalized());
  return groups;
}

}  // namespace foamsim
