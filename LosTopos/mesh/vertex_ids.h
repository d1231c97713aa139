#pragma once

#include <cstdint>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// Numbers that vertices keep for as long as they live, whatever becomes of their slots, and that no vertex gets again:
/// the mesh's attribute "vertex_id". One that a vertex is merged into keeps its own; vertices that operations add have
/// -1 until `number_new`.
class VertexIds {
 public:
  /// Adds the attribute, and numbers the vertices that there are from 0 in the order of their slots.
  explicit VertexIds(SurfaceMesh& mesh);

  /// Gives those without a number the next ones, in the order of their slots. Throws MeshError when there are no more
  /// (2³¹).
  void number_new();

  /// How many have been given, which is the next one. To take up a state: the attribute's values are put back with the
  /// mesh's.
  /// @{
  std::int64_t given() const { return given_; }
  void set_given(std::int64_t given) { given_ = given; }
  /// @}

 private:
  static constexpr std::int32_t none = -1;
  const SurfaceMesh& mesh_;
  VertexAttribute<std::int32_t> ids_;
  std::int64_t given_ = 0;
};

}  // namespace lostopos
