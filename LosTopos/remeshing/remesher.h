#pragma once

#include <vector>

#include "LosTopos/collision/near_triangles.h"
#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/operation_events.h"
#include "LosTopos/remeshing/remesh_options.h"
#include "LosTopos/remeshing/remesh_statistics.h"

namespace lostopos {

/// Keeps a labelled non-manifold mesh at the asked resolution and its triangles well shaped, without ever making it
/// intersect itself (docs/method.md "Remeshing"; Da, Batty, Grinspun 2014). Every operation is planned beside the
/// mesh, checked, and then done or refused for a reason that is counted.
class Remesher {
 public:
  /// `held`: see mesh/hold.h; a new vertex has the attribute's default until an observer (see HoldTransfer) hands on
  /// what its edge's ends have in common. `observers` are told of every operation, in their order. All of them must
  /// outlive the remesher. Throws InputError for options out of range.
  Remesher(SurfaceMesh& mesh, const VertexAttribute<Hold>& held, const RemeshOptions& options,
           std::vector<OperationObserver*> observers = {});

  /// One pass: split long edges, split large angles, collapse short edges, flip, smooth; then aggressive rounds while
  /// triangles are out of bounds. The mesh must not intersect itself. `index`: see SurfaceIndex; without one the pass
  /// builds its own if it finds anything to do. The result depends on nothing but the mesh, `held` and the options. A
  /// pass that finds nothing to do costs a few hundred nanoseconds a triangle. Throws base::Interrupted, or base::Error
  /// beyond the options' most_triangles, between two operations: the mesh is then whole, and half remeshed.
  RemeshStatistics run(NearTriangles* index = nullptr);

 private:
  SurfaceMesh& mesh_;
  const VertexAttribute<Hold>& held_;
  RemeshOptions options_;
  std::vector<OperationObserver*> observers_;
};

}  // namespace lostopos
