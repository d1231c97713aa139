#pragma once

#include <span>
#include <vector>

#include "LosTopos/mesh/operation_events.h"

namespace lostopos::carry {

/// A third of the area of each triangle at v (L²).
double vertex_area(const SurfaceMesh& mesh, Vertex v);

/// The vertices whose areas an operation may change, ascending, each once; for `before_` events.
std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const SplitEvent& event);
std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const CollapseEvent& event);
std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const FlipEvent& event);
std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const MoveEvent& event);
std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const MergeEvent& event);
std::vector<Vertex> patch_of(const SurfaceMesh& mesh, const SeparationEvent& event);

/// Drops what is gone and takes in `joined`, where it is alive and not there yet.
void keep_living(const SurfaceMesh& mesh, std::vector<Vertex>& patch, Vertex joined);

Vertex heaviest_vertex(const Place& place);

/// An edge that an operation made and the one it goes on from.
struct EdgeSource {
  Edge child, parent;
};

/// Finds out which edges an operation makes of which: of those at the vertices that go, part or are joined, and of the
/// edges that are split.
class EdgeOrigins {
 public:
  void before(const SurfaceMesh& mesh, const SplitEvent& event);
  void before(const SurfaceMesh& mesh, const CollapseEvent& event);
  void before(const SurfaceMesh& mesh, const MergeEvent& event);
  void before(const SurfaceMesh& mesh, const SeparationEvent& event);
  /// Valid until the next operation.
  std::span<const EdgeSource> after(const SurfaceMesh& mesh, const SplitEvent& event);
  std::span<const EdgeSource> after(const SurfaceMesh& mesh, const CollapseEvent& event);
  std::span<const EdgeSource> after(const SurfaceMesh& mesh, const MergeEvent& event);
  std::span<const EdgeSource> after(const SurfaceMesh& mesh, const SeparationEvent& event);

 private:
  struct Known {
    Vertex other;  ///< where the edge goes
    Edge edge;
  };
  void note(const SurfaceMesh& mesh, Vertex v);
  std::span<const EdgeSource> made_at(const SurfaceMesh& mesh, Vertex v);

  std::vector<Known> known_;
  std::vector<EdgeSource> sources_;
};

}  // namespace lostopos::carry
