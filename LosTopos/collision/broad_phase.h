#pragma once

#include <memory>
#include <span>
#include <vector>

#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

/// An axis-aligned box, L.
struct Box {
  Vec3 low, high;
  bool overlaps(const Box& other) const {
    return (low.array() <= other.high.array()).all() && (other.low.array() <= high.array()).all();
  }
};

/// Finds the triangles near a box. It holds a box a triangle and is kept up to date under edits, one triangle at a
/// time; edges and vertices are found through the triangles that have them. Queries never miss (boxes that touch
/// count), and their result, sorted by handle, does not depend on the history of edits.
class BroadPhase {
 public:
  BroadPhase();
  BroadPhase(BroadPhase&&) noexcept;
  BroadPhase& operator=(BroadPhase&&) noexcept;
  ~BroadPhase();

  /// Forgets everything and takes in every living triangle: the box of its corners in `from` and `to` (indexed by
  /// vertex handle, L; the same span twice for a surface at rest), grown by `margin` (L) on all sides.
  void build(const SurfaceMesh& mesh, std::span<const Vec3> from, std::span<const Vec3> to, double margin);
  /// Takes in a triangle or changes its box.
  void set(Triangle t, const Box& box);
  /// Forgets a triangle; nothing happens when it is not held.
  void remove(Triangle t);
  /// Appends the triangles whose boxes overlap `box`, each once, sorted. May be called from several threads at a time.
  void query(const Box& box, std::vector<Triangle>& found) const;
  /// The same in no particular order and, rarely, a triangle twice; for callers that sort what they make of it.
  void query_unsorted(const Box& box, std::vector<Triangle>& found) const;
  /// The box of a triangle that is held.
  const Box& box(Triangle t) const;
  /// Bytes held on the heap.
  std::size_t memory_bytes() const;

 private:
  struct Grid;
  std::unique_ptr<Grid> grid_;
};

/// The box of t's corners at `positions`, grown by `margin` (L).
Box triangle_box(const SurfaceMesh& mesh, Triangle t, std::span<const Vec3> positions, double margin);

}  // namespace lostopos
