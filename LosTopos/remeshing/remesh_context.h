#pragma once

#include <functional>
#include <span>
#include <vector>

#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/operation_events.h"
#include "LosTopos/remeshing/change_plan.h"
#include "LosTopos/remeshing/invariants/intersection.h"
#include "LosTopos/remeshing/invariants/invariant.h"
#include "LosTopos/remeshing/settled_vertices.h"
#include "LosTopos/remeshing/surface_index.h"

namespace lostopos {

/// What the operations of one pass share: the mesh, what binds it, and working memory. The mesh must be free of
/// intersections at the start and must not be changed by others while the context is in use.
class RemeshContext {
 public:
  /// `held`: what no operation may move or remove, see mesh/hold.h. `index`: see SurfaceIndex; may be null. Throws
  /// InputError for options out of range.
  RemeshContext(SurfaceMesh& mesh, const VertexAttribute<Hold>& held, const RemeshOptions& options,
                std::span<OperationObserver* const> observers = {}, NearTriangles* index = nullptr)
      : mesh(mesh),
        held(held),
        options(options),
        limits(limits_of(options)),
        index(mesh, index),
        guard(mesh, this->index),
        observers_(observers.begin(), observers.end()) {}
  RemeshContext(const RemeshContext&) = delete;
  RemeshContext& operator=(const RemeshContext&) = delete;
  ~RemeshContext() = default;

  SurfaceMesh& mesh;
  const VertexAttribute<Hold>& held;
  const RemeshOptions options;
  Limits limits;
  SurfaceIndex index;
  IntersectionGuard guard;
  ChangePlan plan;
  StarMotion motion;
  SettledVertices settled;  ///< of smoothing

  /// Tells the mesh's named attributes, then the observers.
  template <class Event>
  void notify(void (OperationObserver::*method)(const SurfaceMesh&, const Event&), const Event& event) const {
    mesh.carry_attributes(method, event);
    for (OperationObserver* observer : observers_) (observer->*method)(mesh, event);
  }

  /// Puts the planned triangles in the place of those they replace, with `fresh` for the planned vertex. The index and
  /// the settled vertices follow. Returns the new triangles' origins, valid until the next operation.
  std::span<const TriangleSource> carry_out(Vertex fresh = Vertex());

 private:
  void disturb(Triangle t);

  std::vector<OperationObserver*> observers_;
  std::vector<TriangleSource> sources_;
};

}  // namespace lostopos
