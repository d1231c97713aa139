#include "LosTopos/collision/safe_move.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

#include "Base/timing/stopwatch.h"
#include "LosTopos/collision/contact_search.h"
#include "LosTopos/collision/impact_zones.h"
#include "LosTopos/collision/impulses.h"
#include "LosTopos/collision/motion.h"
#include "LosTopos/mesh/measures.h"

namespace lostopos {
namespace {

void require_usable(const SurfaceMesh& mesh, std::span<const Vec3> predicted, std::span<const Hold> held,
                    const MoveOptions& options) {
  if (predicted.size() != mesh.vertex_slots() || (!held.empty() && held.size() != mesh.vertex_slots())) {
    throw base::InputError("cannot move the surface: " + std::to_string(predicted.size()) +
                           " predicted positions and " + std::to_string(held.size()) + " held flags for " +
                           std::to_string(mesh.vertex_slots()) +
                           " vertex slots; there has to be one each (or no flags)");
  }
  if (!(options.proximity_epsilon >= 0 && std::isfinite(options.proximity_epsilon)))
    throw base::InputError("proximity_epsilon is " + std::to_string(options.proximity_epsilon) +
                           "; it has to be a length, not negative");
  if (!(options.smallest_step > 0 && options.smallest_step <= 1))
    throw base::InputError("smallest_step is " + std::to_string(options.smallest_step) + "; it has to be in (0, 1]");
  for (Vertex v : mesh.vertices()) {
    if (predicted[v.index()].allFinite()) continue;
    std::ostringstream message;
    message << "cannot move vertex " << v.index() << " from (" << mesh.position(v).transpose()
            << "): its predicted position is not finite";
    throw MotionError(message.str());
  }
}

// Makes one motion safe, over several attempts at fractions of it.
class SafeMove {
 public:
  SafeMove(SurfaceMesh& mesh, std::span<const Vec3> predicted, std::span<const Hold> held, const MoveOptions& options,
           NearTriangles* near)
      : options_(options),
        motion_(mesh, predicted, held),
        search_(mesh, motion_, options.proximity_epsilon, statistics_, near, options.interruption) {}

  // Repels what is close at the start of the whole motion. True when nothing collides then.
  bool is_free() {
    const bool repelled = look_and_repel(1);
    const bool hopeless = std::ranges::any_of(collisions_, [this](const Contact& contact) {
      return std::ranges::none_of(contact.pair.vertices, [this](Vertex v) { return motion_.is_changed(v); });
    });
    if (hopeless) return false;
    if (repelled) search_again();
    return is_done();
  }

  // True when the motion's ends are verified; else collisions() says what is left.
  bool attempt(double fraction) {
    if (look_and_repel(fraction)) search_again();
    if (is_done()) return true;
    ImpactZones zones(motion_);
    return rounds(options_.impulse_passes, statistics_.impulse_seconds, [&] { return impulses(collisions_); }) ||
           rounds(options_.zone_passes, statistics_.zone_seconds,
                  [&] { return zones.solve_inelastic(collisions_, statistics_); }) ||
           rounds(options_.rigid_passes, statistics_.zone_seconds,
                  [&] { return zones.make_rigid(collisions_, statistics_); });
  }

  const std::vector<Contact>& collisions() const { return collisions_; }
  bool gave_up() const { return too_many_; }
  void finish(SurfaceMesh& mesh) const {
    for (Vertex v : mesh.vertices()) mesh.set_position(v, motion_.ends()[v.index()]);
  }
  MoveStatistics& statistics() { return statistics_; }

 private:
  bool is_done() const { return collisions_.empty() && !too_many_; }

  // Looks at the whole motion and repels what is close at its start. Whether that has changed anything.
  bool look_and_repel(double fraction) {
    motion_.restart(fraction);
    const FoundContacts found = search_.all();
    statistics_.proximities += found.proximities.size();
    collisions_ = found.collisions;
    too_many_ = found.too_many;
    return !too_many_ && impulses(found.proximities);
  }

  // Responds and searches until nothing collides (true), nothing changes any more, or the passes are used up.
  template <class Respond>
  bool rounds(int passes, double& seconds, const Respond& respond) {
    for (int pass = 0; pass < passes && !collisions_.empty() && !too_many_; ++pass) {
      options_.interruption.check();
      const base::Stopwatch watch;
      const bool changed = respond();
      seconds += watch.seconds();
      if (!changed) break;
      search_again();
    }
    return is_done();
  }

  bool impulses(std::span<const Contact> contacts) {
    const std::size_t applied = apply_impulses(motion_, contacts);
    statistics_.impulses += applied;
    return applied > 0;
  }

  void search_again() {
    // Those that nothing was done about are still collisions, and so must be found again.
    for (const Contact& contact : collisions_) {
      for (Vertex v : contact.pair.vertices) motion_.note_changed(v);
    }
    FoundContacts found = search_.again();
    collisions_ = std::move(found.collisions);
    too_many_ = found.too_many;
  }

  const MoveOptions& options_;
  MoveStatistics statistics_;
  Motion motion_;
  ContactSearch search_;
  std::vector<Contact> collisions_;
  bool too_many_ = false;  // to go on with
};

// The search has been given up: what is in its way are the mesh's sizes, or the length of the motion.
[[noreturn]] void fail_crowded(const SurfaceMesh& mesh, std::span<const Vec3> predicted,
                               const std::vector<Contact>& contacts, double fraction) {
  constexpr double very_different = 100;
  double shortest = std::numeric_limits<double>::infinity(), longest = 0, farthest = 0;
  for (Edge e : mesh.edges()) {
    shortest = std::min(shortest, length(mesh, e));
    longest = std::max(longest, length(mesh, e));
  }
  for (Vertex v : mesh.vertices()) farthest = std::max(farthest, (predicted[v.index()] - mesh.position(v)).norm());
  std::ostringstream message;
  message << "cannot move the surface: even at " << fraction << " of the step so many of its " << mesh.triangle_count()
          << " triangles come near each other that the search for collisions was given up. Edges are " << shortest
          << " to " << longest << " long, and vertices are to move by up to " << farthest << ": ";
  if (longest > very_different * shortest)
    message << "the sizes of its triangles are too different, for a large one is near very many small ones; a mesh of "
               "more even edges (remeshing does that) would help";
  else
    message << "a shorter time step would help";
  throw CollisionFailure(message.str(), contacts);
}

[[noreturn]] void fail(const SurfaceMesh& mesh, const std::vector<Contact>& contacts, double fraction) {
  std::ostringstream message;
  message << "cannot move the surface without intersection, even after cutting the step down to " << fraction
          << " of it; " << contacts.size() << " pair(s) still collide";
  constexpr std::size_t most_named = 5;
  for (std::size_t i = 0; i < std::min(contacts.size(), most_named); ++i) {
    const ElementPair& pair = contacts[i].pair;
    const bool edges = pair.kind == ElementPair::Kind::edge_edge;
    message << (i == 0 ? ": " : "; ") << (edges ? "edge " : "vertex ") << pair.first << " and "
            << (edges ? "edge " : "triangle ") << pair.second << " near ("
            << mesh.position(pair.vertices[0]).transpose() << ")";
  }
  message << ". A shorter time step or a motion that agrees with that of the held vertices would help";
  throw CollisionFailure(message.str(), contacts);
}

}  // namespace

MoveStatistics& MoveStatistics::operator+=(const MoveStatistics& other) {
  pairs += other.pairs;
  proximities += other.proximities;
  collisions += other.collisions;
  impulses += other.impulses;
  inelastic_zones += other.inelastic_zones;
  rigid_zones += other.rigid_zones;
  largest_zone = std::max(largest_zone, other.largest_zone);
  halvings += other.halvings;
  broad_phase_seconds += other.broad_phase_seconds;
  ccd_seconds += other.ccd_seconds;
  impulse_seconds += other.impulse_seconds;
  zone_seconds += other.zone_seconds;
  return *this;
}

MoveResult move_safely(SurfaceMesh& mesh, std::span<const Vec3> predicted, std::span<const Hold> held,
                       const MoveOptions& options, NearTriangles* near) {
  require_usable(mesh, predicted, held, options);
  SafeMove move(mesh, predicted, held, options, near);
  double fraction = 1;
  while (!move.attempt(fraction)) {
    if (fraction / 2 < options.smallest_step) {
      if (move.gave_up()) fail_crowded(mesh, predicted, move.collisions(), fraction);
      fail(mesh, move.collisions(), fraction);
    }
    fraction /= 2;
    ++move.statistics().halvings;
  }
  move.finish(mesh);
  return {move.statistics(), fraction};
}

MoveResult move_if_free(SurfaceMesh& mesh, std::span<const Vec3> predicted, std::span<const Hold> held,
                        const MoveOptions& options, NearTriangles* near) {
  require_usable(mesh, predicted, held, options);
  SafeMove move(mesh, predicted, held, options, near);
  if (!move.is_free()) return {move.statistics(), 0};
  move.finish(mesh);
  return {move.statistics(), 1};
}

}  // namespace lostopos
