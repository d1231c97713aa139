#pragma once

#include <vector>

#include "Base/interruption.h"
#include "LosTopos/collision/broad_phase.h"
#include "LosTopos/collision/contact.h"
#include "LosTopos/collision/motion.h"
#include "LosTopos/collision/near_triangles.h"
#include "LosTopos/collision/pair_test.h"
#include "LosTopos/collision/rounded_box.h"
#include "LosTopos/collision/safe_move.h"

namespace lostopos {

struct FoundContacts {
  std::vector<Contact> proximities;
  std::vector<Contact> collisions;
  /// The motion is so wild, or triangles are of so different sizes, that the search has been given up: more than 10,000
  /// + 20 collisions a triangle, or 200,000 + 100 near pairs a triangle. Then these are only a part.
  bool too_many = false;
};

/// Finds what comes too near in a motion: all pairs once, then only pairs of which a vertex has changed. Pairs are
/// reached through triangles; an edge or a vertex belongs to the first triangle in its list, so that every pair comes
/// up once. Triangles that are near each other are taken from given lists where these cover the motion, and else found
/// by the boxes they sweep. Runs in parallel; results are sorted by pair, and the same either way.
class ContactSearch {
 public:
  /// The mesh, the motion and `near` must outlive this; ε_c in L. `near`: lists to be used and brought up to date; or
  /// null. Counts and times are added to `statistics`. `interruption`: asked every few thousand triangles; a search
  /// that is interrupted throws.
  ContactSearch(const SurfaceMesh& mesh, Motion& motion, double proximity_epsilon, MoveStatistics& statistics,
                NearTriangles* near = nullptr, base::Interruption interruption = {});

  /// Looks at every pair. Forgets the motion's changes.
  FoundContacts all();
  /// Looks at the pairs with a changed vertex: all collisions, when there were none among the others at the last
  /// search. Forgets the motion's changes.
  FoundContacts again();

 private:
  struct Scratch;
  void begin_with_lists();
  void begin_with_boxes();
  void add_subject(Triangle t);
  void note_owned(Triangle t);
  void note_box(Vertex v);
  void note_boxes(bool of_all);
  Box box(Triangle t) const;
  RoundedBox rounded_box(std::span<const Vertex> vertices) const;
  double largest_extent() const;
  void update_boxes();
  FoundContacts search(bool changed_only);
  struct Scratches;
  void search_block(std::size_t first, std::size_t last, bool changed_only, Scratches& scratches);
  void gather(const Scratches& scratches, FoundContacts& found);
  void collect(Triangle t, bool changed_only, Scratch& scratch) const;
  void pair_vertices(Triangle t, Triangle u, const RoundedBox& box_of_u, bool changed_only, Scratch& scratch) const;
  void pair_edges(Triangle t, Triangle u, const RoundedBox& box_of_u, bool changed_only, Scratch& scratch) const;

  const SurfaceMesh& mesh_;
  Motion& motion_;
  MoveStatistics& statistics_;
  ContactScale scale_;
  double margin_;  // boxes of pairs nearer than ε_c overlap
  NearTriangles* near_;
  base::Interruption interruption_;
  bool uses_lists_ = false;  // or else the broad phase
  BroadPhase broad_phase_;
  std::vector<RoundedBox> vertex_boxes_;  // that vertices sweep; those of their edges and triangles are made of them
  std::vector<unsigned char> owned_;      // by triangle: bits 0-2 its edges, 3-5 its vertices that belong to it
  std::vector<Triangle> subjects_;        // whose pairs are looked at
  std::vector<char> is_subject_;
};

}  // namespace lostopos
