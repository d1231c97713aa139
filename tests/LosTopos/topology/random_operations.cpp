#include "tests/LosTopos/topology/random_operations.h"

#include <cmath>
#include <iterator>
#include <ostream>

#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/edge_collapse.h"
#include "LosTopos/remeshing/edge_flip.h"
#include "LosTopos/remeshing/edge_split.h"
#include "LosTopos/remeshing/null_space_smoothing.h"
#include "LosTopos/topology/near_pairs.h"
#include "LosTopos/topology/place_merge.h"
#include "LosTopos/topology/vertex_separation.h"

namespace lostopos::test {
namespace {

template <class Range>
auto element(const Range& range, std::size_t count, std::uint32_t choice) {
  auto it = range.begin();
  std::advance(it, choice % count);
  return *it;
}

std::optional<Refusal> snap(RemeshContext& context, double distance, const RandomOperation& operation) {
  const SurfaceMesh& mesh = context.mesh;
  const auto pairs = near_pairs(mesh, distance);
  if (pairs.empty()) return Refusal::not_better;
  const NearPair& near = pairs[operation.element % pairs.size()];
  const auto& w = near.weights;
  const bool edges = near.pair.kind == ElementPair::Kind::edge_edge;
  const Site a = edges ? site_on(mesh, Edge(near.pair.first), w[1]) : site_at(mesh, Vertex(near.pair.first));
  const Site b = edges ? site_on(mesh, Edge(near.pair.second), w[3])
                       : site_in(mesh, Triangle(near.pair.second), {w[1], w[2], w[3]});
  const double reach = operation.exact ? 0 : distance;
  return PlaceMerge(context).attempt(settled(mesh, a, reach), settled(mesh, b, reach), {});
}

std::optional<Refusal> separate(RemeshContext& context, double distance) {
  VertexSeparation separation(context, SeparationRule::area, distance, {});
  for (Vertex v : context.mesh.vertices())
    if (!is_complete(context.mesh, v)) return separation.attempt(v);
  return Refusal::not_better;
}

}  // namespace

std::ostream& operator<<(std::ostream& out, const RandomOperation& operation) {
  static constexpr std::array<const char*, operation_kinds> names = {"split",        "collapse", "flip", "smooth",
                                                                     "merge joined", "separate", "snap", "snap again"};
  return out << names.at(static_cast<std::size_t>(operation.kind)) << ' ' << operation.element
             << (operation.exact ? " exact" : "");
}

std::optional<Refusal> perform(RemeshContext& context, double distance, const RandomOperation& operation) {
  const SurfaceMesh& mesh = context.mesh;
  const Edge e = element(mesh.edges(), mesh.edge_count(), operation.element);
  switch (operation.kind) {
    case OperationKind::split:
      return EdgeSplit(context).attempt(e);
    case OperationKind::collapse:
      return EdgeCollapse(context).attempt(e);
    case OperationKind::flip:
      return EdgeFlip(context).attempt(e);
    case OperationKind::smooth:
      return NullSpaceSmoothing(context).attempt(element(mesh.vertices(), mesh.vertex_count(), operation.element));
    case OperationKind::merge_joined: {
      const auto [a, b] = mesh.vertices(e);
      return PlaceMerge(context).attempt(site_at(mesh, a), site_at(mesh, b),
                                         {.joined_vertices = true, .keeps_orientation = operation.exact});
    }
    case OperationKind::separate:
      return separate(context, distance);
    default:
      return snap(context, distance, operation);
  }
}

Cargo::Cargo(SurfaceMesh& mesh)
    : mesh_(mesh),
      density_(mesh.add_vertex_attribute<double>("density", carry::conserve)),
      share_(mesh.add_vertex_attribute<double>("share", carry::interpolate, 100)),
      marked_(mesh.add_triangle_attribute<int>("marked", carry::copy)),
      line_(mesh.add_edge_attribute<int>("line", carry::copy)) {
  for (Vertex v : mesh_.vertices()) {
    density_[v] = 1 + 0.5 * std::sin(3.0 * v.index());
    share_[v] = std::cos(7.0 * v.index());
  }
  for (Triangle t : mesh_.triangles()) marked_[t] = 1;
  measure();
}

double Cargo::integral() const {
  double sum = 0;
  for (Triangle t : mesh_.triangles())
    for (Vertex v : mesh_.vertices(t)) sum += area(mesh_, t) / 3 * density_[v];
  return sum;
}

bool Cargo::holds() const {
  for (Vertex v : mesh_.vertices())
    if (!(std::abs(share_[v]) <= 1 + 1e-12 && density_[v] > 0)) return false;
  for (Triangle t : mesh_.triangles())
    if (marked_[t] != 1) return false;
  return std::abs(integral() - amount_) <= 1e-11 * amount_;
}

}  // namespace lostopos::test
