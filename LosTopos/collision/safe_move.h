#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "Base/interruption.h"
#include "LosTopos/collision/contact.h"
#include "LosTopos/error.h"
#include "LosTopos/mesh/hold.h"
#include "LosTopos/mesh/surface_mesh.h"

namespace lostopos {

class NearTriangles;

struct MoveOptions {
  /// ε_c: elements nearer than this at the start of the step are pushed apart, L (1e-4 h̄ in docs/method.md). At 0
  /// nothing is.
  double proximity_epsilon = 0;
  /// Rounds of impulses between single pairs, of inelastic impact zones, and of rigid impact zones; each ends earlier
  /// when nothing collides any more.
  int impulse_passes = 5;
  int zone_passes = 15;
  int rigid_passes = 40;
  /// The motion is halved as long as the fraction that is left is not smaller than this.
  double smallest_step = 1.0 / 64;
  base::Interruption interruption = {};  ///< asked while pairs are looked for, and before every round
};

/// What one call of move_safely did; sums over all its attempts.
struct MoveStatistics {
  std::size_t pairs = 0;            ///< pairs of elements with overlapping swept boxes
  std::size_t proximities = 0;      ///< pairs nearer than ε_c at the start
  std::size_t collisions = 0;       ///< colliding pairs found, in every round anew
  std::size_t impulses = 0;         ///< that changed a motion, repulsions included
  std::size_t inelastic_zones = 0;  ///< solved
  std::size_t rigid_zones = 0;      ///< moved as one, in every round anew
  std::size_t largest_zone = 0;     ///< free vertices
  std::size_t halvings = 0;
  /// The two that run in parallel are summed over threads.
  double broad_phase_seconds = 0;
  double ccd_seconds = 0;  ///< distances and continuous collision detection
  double impulse_seconds = 0;
  double zone_seconds = 0;
  MoveStatistics& operator+=(const MoveStatistics& other);
};

struct MoveResult {
  MoveStatistics statistics;
  double fraction = 1;  ///< of the asked motion that was done; 1 is all of it
};

/// The surface cannot be moved where it is asked to go without intersection; it is where it was.
class CollisionFailure : public MotionError {
 public:
  CollisionFailure(const std::string& message, std::vector<Contact> contacts)
      : MotionError(message), contacts_(std::move(contacts)) {}
  /// What still collided in the last attempt, sorted by element.
  const std::vector<Contact>& contacts() const { return contacts_; }

 private:
  std::vector<Contact> contacts_;
};

/// Moves the vertices to positions near `predicted` so that on the straight way there no vertex meets a triangle and no
/// edge an edge but those it has a vertex in common with.
///
/// predicted: L, indexed by vertex handle, one per slot (dead slots are not read). held: the same size, see
/// mesh/hold.h: held vertices, and the held coordinates of those that slide, go to their predicted positions to the bit
/// (at a fraction < 1: to that fraction of the way); empty when there are none. All other vertices have the same mass,
/// and responses between them keep the sum of their displacements. near: see ContactSearch; it makes the search faster
/// and changes nothing else.
///
/// Method: Bridson, Fedkiw and Anderson 2002, "Robust treatment of collisions, contact and friction for cloth
/// animation" (repulsions, impulses, rigid impact zones); Harmon, Vouga, Tamstorf and Grinspun 2008, "Robust treatment
/// of simultaneous collisions" (inelastic impact zones); then smaller steps. Other than in these, elements that collide
/// may close half of the gap between them: so what is pressed together comes close enough to be joined.
///
/// Guarantee: the motion that is done has been found free of contact by the conservative detection of geometry/ccd.h
/// for all pairs; what cannot be verified is not done. Near pairs come no nearer than half their distance in a step
/// once they are within ε_c / 1000. The result is the same to the bit for any number of threads. Bounded: at most
/// impulse_passes + zone_passes + rigid_passes rounds an attempt and log2(1 / smallest_step) + 1 attempts.
/// An attempt at a motion so wild that nearly all elements cross each other is given up early (see FoundContacts).
/// Throws InputError when a span has the wrong size or an option is out of range, MotionError for a prediction that is
/// not finite, base::Interrupted, and CollisionFailure when the smallest step still collides (a surface that is in
/// contact with itself at the start always does, if it is asked to move there); the mesh is then unchanged.
MoveResult move_safely(SurfaceMesh& mesh, std::span<const Vec3> predicted, std::span<const Hold> held,
                       const MoveOptions& options, NearTriangles* near = nullptr);

/// The same when nothing collides on the way (repulsions aside): else the surface stays where it is, and the result's
/// fraction is 0.
MoveResult move_if_free(SurfaceMesh& mesh, std::span<const Vec3> predicted, std::span<const Hold> held,
                        const MoveOptions& options, NearTriangles* near = nullptr);

}  // namespace lostopos
