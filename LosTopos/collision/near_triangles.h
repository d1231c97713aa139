#pragma once

#include <boost/container/small_vector.hpp>
#include <span>
#include <vector>

#include "LosTopos/collision/broad_phase.h"

namespace lostopos {

/// Which triangles of a surface are near each other or near a box, kept from step to step while the surface moves and
/// changes: the one structure that collisions, topology and remeshing search.
///
/// Every vertex has a place, and is held to be anywhere within `slack` of it. Triangles are listed by their places, and
/// two are near when elements of theirs come nearer than reach + 2 slack there: so elements of triangles that are not
/// listed stay farther apart than `reach` for as long as vertices stay within the slack. Only where one leaves it, or
/// triangles are made, is the surface looked at again. (Verlet 1967, "Computer experiments on classical fluids", did
/// so with atoms.) What a search finds by it is, after its own test of distances, the same as from anew.
class NearTriangles {
 public:
  struct Margins {
    double reach = 0;  ///< L
    double slack = 0;  ///< L
  };

  NearTriangles() : NearTriangles(Margins{0, 0}) {}
  explicit NearTriangles(const Margins& margins) : margins_(margins) {}

  const Margins& margins() const { return margins_; }

  /// Takes in whatever the mesh has become since the last call, and a motion of its vertices on straight lines between
  /// `from` and `to` (L, indexed by vertex handle). False when a vertex moves by more than twice the slack: then it is
  /// the motion's start that is taken in.
  bool follow(const SurfaceMesh& mesh, std::span<const Vec3> from, std::span<const Vec3> to);
  /// Whether v at x is within the slack.
  bool covers(Vertex v, const Vec3& x) const { return holds(places_[v.index()], x); }

  /// @name While operations change the mesh
  ///@{
  /// A triangle was added or its corners moved.
  void changed(const SurfaceMesh& mesh, Triangle t);
  void removed(Triangle t);
  ///@}

  /// Makes the lists that are missing.
  void complete(const SurfaceMesh& mesh);
  /// The triangles of which an element may be nearer than `reach` to one of t's, elements that have a vertex in common
  /// aside; in no particular order. For when all lists are complete.
  std::span<const Triangle> near(Triangle t) const { return {near_[t.index()].data(), near_[t.index()].size()}; }
  /// Appends those for all triangles at v, some perhaps more than once. False, with some of them, when that would take
  /// a search: one of v's triangles has changed and has no list yet, or so many others have that it has not paid yet to
  /// make theirs.
  bool append_around(const SurfaceMesh& mesh, Vertex v, std::vector<Triangle>& found);
  /// The triangles that overlap `box` (their own boxes do), sorted, in `found` (cleared first).
  void overlapping(const SurfaceMesh& mesh, const Box& box, std::vector<Triangle>& found) const;
  /// Bytes held on the heap.
  std::size_t memory_bytes() const;

 private:
  using List = boost::container::small_vector<Triangle, 2>;

  bool holds(const Vec3& place, const Vec3& x) const {
    return (x - place).squaredNorm() <= margins_.slack * margins_.slack;
  }
  bool move_places(const SurfaceMesh& mesh, std::span<const Vec3> from, std::span<const Vec3> to);
  void take_in(const SurfaceMesh& mesh, Triangle t);
  void note_stale(Triangle t);
  void forget_neighbours(Triangle t);
  void search(const SurfaceMesh& mesh, Triangle t, std::vector<Triangle>& candidates, List& found) const;

  Margins margins_;
  std::vector<Vec3> places_;                    // by vertex
  std::vector<char> is_moved_;                  // by vertex, while following
  std::vector<std::array<Vertex, 3>> corners_;  // by triangle; invalid where none is held
  BroadPhase boxes_;                            // of the corners' places, grown by the slack
  std::vector<List> near_;                      // by triangle, both ways
  std::vector<Triangle> stale_;                 // whose lists have to be made; some may be gone
  std::vector<char> is_stale_;
  std::size_t turned_away_ = 0;  // from so many stale triangles, since the lists were complete
};

}  // namespace lostopos
