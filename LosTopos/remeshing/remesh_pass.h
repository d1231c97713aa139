#pragma once

#include <vector>

#include "LosTopos/remeshing/edge_collapse.h"
#include "LosTopos/remeshing/edge_flip.h"
#include "LosTopos/remeshing/edge_split.h"
#include "LosTopos/remeshing/null_space_smoothing.h"
#include "LosTopos/remeshing/remesh_statistics.h"

namespace lostopos {

/// The stages of one remeshing pass. Each looks over the whole mesh once, lists what needs work (worst first, equals by
/// handle), works through the list, and then at most max_sweeps − 1 times through what its own operations have made.
class RemeshPass {
 public:
  RemeshPass(RemeshContext& context, RemeshStatistics& statistics);

  void split_long_edges();      ///< longest first
  void split_large_angles();    ///< the edges opposite to them, largest angle first
  void collapse_short_edges();  ///< shortest first
  void flip_edges();            ///< in order of handles
  void smooth();                ///< vertices of triangles with a small angle, in order of handles
  /// With relaxed bounds, for every triangle that is out of bounds, worst first: flip or split its longest edge, or
  /// collapse its shortest; then smooth its corners.
  void mend_bad_triangles();

  /// Whether a triangle is out of bounds by its area or an angle.
  bool is_bad(Triangle t) const;
  bool has_bad_triangles() const;
  /// Counts what is left out of bounds, by the reason for it.
  void count_what_is_left();

 private:
  /// Something to work on; the smallest key comes first.
  template <class H>
  struct Task {
    double key;
    H element;
    bool operator==(const Task& other) const { return key == other.key && element == other.element; }
    bool operator<(const Task& other) const { return key != other.key ? key < other.key : element < other.element; }
  };
  template <class H>
  using Tasks = std::vector<Task<H>>;

  bool too_long(Edge e) const { return squared_length(e) > longest_ * longest_; }
  bool too_short(Edge e) const { return squared_length(e) < shortest_ * shortest_; }
  double squared_length(Edge e) const;
  void mend(Triangle t);
  void require_room() const;
  bool try_split(Edge e);
  bool try_collapse(Edge e);
  bool try_flip(Edge e);
  void list_flips_near(std::span<const Vertex> vertices, Tasks<Edge>& list) const;

  RemeshContext& c_;
  RemeshStatistics& statistics_;
  EdgeSplit split_;
  EdgeCollapse collapse_;
  EdgeFlip flip_;
  NullSpaceSmoothing smoothing_;
  double shortest_, longest_;
  Tasks<Edge> tasks_, next_tasks_;
};

}  // namespace lostopos
