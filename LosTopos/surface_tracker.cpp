#include "LosTopos/surface_tracker.h"

#include <cmath>
#include <limits>
#include <sstream>

#include "Base/timing/stopwatch.h"
#include "LosTopos/error.h"
#include "LosTopos/mesh/length_range.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/mesh/place_order.h"
#include "LosTopos/remeshing/hold_transfer.h"
#include "LosTopos/remeshing/limits.h"
#include "LosTopos/remeshing/remesher.h"
#include "LosTopos/topology/topology_pass.h"

namespace lostopos {
namespace {

// Sums over all slots cost little while few of them are dead.
constexpr double most_dead_slots = 0.1;

// How far vertices move, over h̄, before the search for what is near them is done again.
constexpr double slack = 0.11;

NearTriangles::Margins margins_of(const TrackerOptions& options) {
  const double merged = options.topology.enabled ? options.topology.merge_distance : 0;
  return {.reach = std::max(merged, options.proximity_epsilon) * options.resolution,
          .slack = slack * options.resolution};
}

// A surface of so many triangles is not in the processor's caches as a whole, so that its order in memory matters.
constexpr std::size_t large_surface = 50'000;

bool has_many_gaps(const SurfaceMesh& mesh) {
  const auto gaps = [](std::size_t living, std::size_t slots) {
    return static_cast<double>(slots - living) > most_dead_slots * static_cast<double>(slots);
  };
  return gaps(mesh.vertex_count(), mesh.vertex_slots()) || gaps(mesh.triangle_count(), mesh.triangle_slots());
}

void put_in_order(SurfaceMesh& mesh) {
  const bool large = mesh.triangle_count() >= large_surface;
  if (has_many_gaps(mesh) || (large && is_scattered(mesh)))
    mesh.compact(large ? SlotOrder::by_place : SlotOrder::as_before);
}

}  // namespace

SurfaceTracker::SurfaceTracker(SurfaceMesh mesh, const TrackerOptions& options)
    : mesh_(std::move(mesh)),
      options_(options),
      held_(add_hold_attribute(mesh_)),
      solid_(mesh_.add_triangle_attribute<std::uint8_t>("solid", carry::copy)),
      near_(margins_of(options)) {
  options_.remesh.target_edge = options_.resolution;
  options_.remesh.interruption = options_.move.interruption = options_.interruption;
  if ((options_.remeshing || options_.collisions) && !(options_.resolution > 0))
    throw base::InputError("a tracker that remeshes or keeps surfaces apart needs a resolution > 0");
  if (options_.resolution > 0)
    if (const std::string problem = resolution_problem(options_.resolution); !problem.empty())
      throw base::InputError(problem);
  require_lengths_in_range(mesh_);
  if (options_.remeshing) limits_of(options_.remesh);  // throws where bounds contradict each other
  if (options_.topology.enabled || options_.keep_motion)
    motion_ = mesh_.add_vertex_attribute<Vec3>("motion", carry::interpolate, Vec3::Zero());
}

MoveResult SurfaceTracker::advance(std::span<const Vec3> predicted) {
  require_resolved(predicted);
  return move_to(predicted);
}

MoveOptions SurfaceTracker::move_options() const {
  MoveOptions options = options_.move;
  options.proximity_epsilon = options_.proximity_epsilon * options_.resolution;
  return options;
}

MoveResult SurfaceTracker::move_to(std::span<const Vec3> predicted) {
  if (options_.collisions) return move_safely(mesh_, predicted, held_.slots(), move_options(), &near_);
  for (Vertex v : mesh_.vertices()) mesh_.set_position(v, predicted[v.index()]);
  return {};
}

void SurfaceTracker::require_resolved(std::span<const Vec3> predicted) const {
  if (predicted.size() != mesh_.vertex_slots())
    throw MeshError("cannot move the surface: " + std::to_string(predicted.size()) + " predicted positions for " +
                    std::to_string(mesh_.vertex_slots()) + " vertex slots; there has to be one each");
  const double farthest =
      options_.resolution > 0 ? options_.largest_motion * options_.resolution : std::numeric_limits<double>::infinity();
  for (Vertex v : mesh_.vertices()) {
    const Vec3& x = mesh_.position(v);
    const Vec3& to = predicted[v.index()];
    const bool in_range = (to.array().abs() <= largest_length).all();
    if (in_range && !((to - x).norm() > farthest)) continue;
    std::ostringstream message;
    message << "cannot move vertex " << v.index() << " from (" << x.transpose() << ") to (" << to.transpose() << "): ";
    if (in_range)
      message << "that is more than " << options_.largest_motion
              << " resolutions in one step; a smaller dt resolves it";
    else
      message << "the predicted position is not finite, or beyond the lengths that can be computed with";
    throw MotionError(message.str());
  }
}

void SurfaceTracker::move_part(std::span<const Vec3> predicted, TrackerStep& done) {
  const base::TimedScope timed(done.move_seconds);
  const double asked = total_area(mesh_, predicted);
  const MoveResult moved = move_to(predicted);
  done.move.statistics += moved.statistics;
  done.move.fraction += moved.fraction / done.parts;
  done.move_area += total_area(mesh_) - asked;
}

void SurfaceTracker::improve(TrackerStep& done, const AfterStage& after) {
  const auto tell = [&after](TrackerStage stage) {
    if (after) after(stage);
  };
  tell(TrackerStage::move);
  const double moved = total_area(mesh_);
  {
    const base::TimedScope timed(done.topology_seconds);
    done.topology += change_topology();
  }
  tell(TrackerStage::topology);
  const double changed = total_area(mesh_);
  {
    const base::TimedScope timed(done.remesh_seconds);
    done.remesh += remesh();
  }
  tell(TrackerStage::remesh);
  done.topology_area += changed - moved;
  done.remesh_area += total_area(mesh_) - changed;
}

// Returns the length of the longest displacement, L.
double SurfaceTracker::note_motion(std::span<const Vec3> predicted) {
  double longest = 0;
  for (Vertex v : mesh_.vertices()) {
    Vec3& motion = (*motion_)[v];
    motion = predicted[v.index()] - mesh_.position(v);
    longest = std::max(longest, motion.squaredNorm());
  }
  return std::sqrt(longest);
}

// How many parts the motion is to be done in; 0: it has been done, since nothing was in its way.
int SurfaceTracker::parts_of(std::span<const Vec3> predicted, TrackerStep& done) {
  if (!motion_) return 1;
  const double farthest = note_motion(predicted);
  if (!options_.topology.enabled) return 1;
  const double longest = options_.topology.longest_motion * options_.resolution;
  const int parts = std::max(1, static_cast<int>(std::ceil(farthest / longest - 1e-9)));
  if (parts == 1 || !options_.collisions) return 1;
  const base::TimedScope timed(done.move_seconds);
  done.move = move_if_free(mesh_, predicted, held_.slots(), move_options(), &near_);
  return done.move.fraction > 0 ? 0 : parts;
}

TrackerStep SurfaceTracker::step(std::span<const Vec3> predicted, const FollowsMotion& follows,
                                 const AfterStage& after) {
  require_resolved(predicted);
  TrackerStep done;
  done.move.fraction = 0;
  const int parts = parts_of(predicted, done);
  done.parts = std::max(1, parts);
  if (parts == 1) move_part(predicted, done);
  if (parts <= 1) {
    improve(done, after);
    return done;
  }
  std::vector<Vec3> targets;
  for (int part = 0; part < parts; ++part) {
    options_.interruption.check();
    targets.assign(mesh_.positions().begin(), mesh_.positions().end());
    for (Vertex v : mesh_.vertices())
      if (part == 0 || !follows || follows(v)) targets[v.index()] += (*motion_)[v] / parts;
    move_part(targets, done);
    improve(done, after);
  }
  return done;
}

TopologyStatistics SurfaceTracker::change_topology() {
  TopologyStatistics statistics;
  const TopologyOptions& options = options_.topology;
  if (!options.enabled) return statistics;
  const base::Stopwatch watch;
  RemeshContext context(mesh_, held_, options_.remesh, observers_.observers(), &near_);
  TopologyPass pass(
      context, options, [this](Vertex v) { return (*motion_)[v]; }, statistics);
  if (options.collapse_regions) pass.collapse_small_regions();
  if (options.snap) {
    pass.merge_short_edges();
    pass.snap_near_places();
  }
  if (options.separate) pass.separate_vertices();
  pass.count_what_is_left();
  statistics.seconds = watch.seconds();
  return statistics;
}

RemeshStatistics SurfaceTracker::remesh() {
  RemeshStatistics statistics;
  if (!options_.remeshing) return statistics;
  for (int i = 0; i < options_.remeshing_iterations; ++i) {
    Remesher remesher(mesh_, held_, options_.remesh, observers_.observers());
    statistics += remesher.run(&near_);
  }
  put_in_order(mesh_);
  return statistics;
}

}  // namespace lostopos
