#pragma once

#include <cstdint>
#include <iosfwd>
#include <optional>

#include "LosTopos/remeshing/refusal.h"
#include "LosTopos/remeshing/remesh_context.h"

namespace lostopos::test {

/// What may be asked of any mesh at any time, whether there is need of it or not.
enum class OperationKind { split, collapse, flip, smooth, merge_joined, separate, snap, snap_again };
inline constexpr int operation_kinds = 8;

/// `element`: counts through those that the operation may be asked of. `exact`: a merge does not turn triangles, a snap
/// joins the very places that are near and not the vertices next to them.
struct RandomOperation {
  OperationKind kind = OperationKind::split;
  std::uint32_t element = 0;
  bool exact = false;
};

std::ostream& operator<<(std::ostream& out, const RandomOperation& operation);

/// `distance`: L, what is nearer may be snapped, and what is separated gets so far apart.
std::optional<Refusal> perform(RemeshContext& context, double distance, const RandomOperation& operation);

/// Attributes that go along with the operations.
class Cargo {
 public:
  /// Adds them to the mesh, which must outlive this.
  explicit Cargo(SurfaceMesh& mesh);

  /// Whether what has to hold of them after every operation does: the conserved one keeps its integral, the one that is
  /// interpolated its range, and the one that is copied its value.
  bool holds() const;

  /// Begins anew with the integral of now, after changes that do not conserve it: motion.
  void measure() { amount_ = integral(); }

 private:
  double integral() const;

  SurfaceMesh& mesh_;
  VertexAttribute<double> density_, share_;
  TriangleAttribute<int> marked_;
  EdgeAttribute<int> line_;
  double amount_ = 0;
};

}  // namespace lostopos::test
