#include "tests/LosTopos/topology/operation_fuzzer.h"

#include <optional>
#include <random>
#include <sstream>
#include <vector>

#include "LosTopos/collision/safe_move.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/remeshing/remesh_context.h"
#include "LosTopos/shapes/voronoi_foam.h"
#include "tests/LosTopos/remeshing/patches.h"
#include "tests/LosTopos/topology/clusters.h"
#include "tests/LosTopos/topology/random_operations.h"
#include "tests/support/film_meshes.h"

namespace lostopos::test {
namespace {

struct Start {
  std::string name;
  SurfaceMesh mesh;
  std::vector<Vertex> held = {};
  bool closed = true;
};

class Fuzzer {
 public:
  explicit Fuzzer(std::uint64_t seed) : bits_(seed), start_(start()), cargo_(mesh_) {
    for (Vertex v : start_.held) held_[v] = Hold::all;
    log_ << "seed " << seed << ", " << start_.name;
  }

  FuzzRound run(int operations) {
    for (int i = 0; i < operations && round_.failure.empty() && mesh_.triangle_count() > 0; ++i) {
      const auto choice = integer(0, 19);
      choice == 0 ? compact() : choice <= 3 ? move(choice == 3) : operate();
    }
    return round_;
  }

 private:
  std::uint32_t integer(std::uint32_t low, std::uint32_t high) {
    return low + static_cast<std::uint32_t>(bits_() % (high - low + 1));
  }
  double uniform() { return static_cast<double>(bits_() >> 11U) * 0x1p-53; }
  Vec3 random_vector() {
    const double x = uniform(), y = uniform();
    return 2 * Vec3(x, y, uniform()) - Vec3::Ones();
  }

  Start start();
  void operate();
  void move(bool squeezing);
  void compact();
  void check(bool changed, const SurfaceMesh::State& before);

  std::mt19937_64 bits_;
  Start start_;
  SurfaceMesh& mesh_ = start_.mesh;
  Cargo cargo_;
  VertexAttribute<Hold> held_ = mesh_.add_vertex_attribute<Hold>(Hold::none);
  std::optional<RemeshContext> context_;  // none after changes that are not its own
  double length_ = mean_edge_length(mesh_);
  std::ostringstream log_;
  FuzzRound round_;
};

Start Fuzzer::start() {
  switch (integer(0, 4)) {
    case 0:
      return {"double bubble", analytic_double_bubble(1, integer(6, 14))};
    case 1:
      return {"two spheres", two_spheres(1, 0.1, Region(1), Region(integer(1, 2)))};
    case 2: {
      CubeFrame cube = cube_frame(integer(1, 5));
      return {"cube frame", std::move(cube.mesh), std::move(cube.frame), false};
    }
    case 3:
      return {"columns", four_columns({Region(1), Region(2), Region(integer(0, 1) == 0 ? 1 : 3), Region(4)})};
    default:
      return {"foam", voronoi_foam({.cells = integer(4, 20), .seed = integer(1, 1000)})};
  }
}

void Fuzzer::operate() {
  const auto kind = static_cast<OperationKind>(integer(0, operation_kinds - 1));
  const RandomOperation operation{kind, integer(0, 1U << 30U), integer(0, 1) == 0};
  log_ << "; " << operation << std::flush;
  const SurfaceMesh::State before = mesh_.state();
  if (!context_) context_.emplace(mesh_, held_, wide_bounds());
  check(!perform(*context_, 0.4 * length_, operation), before);
}

// All vertices somewhere near, or those about one towards a line through it.
void Fuzzer::move(bool squeezing) {
  log_ << (squeezing ? "; squeeze" : "; move");
  const SurfaceMesh::State before = mesh_.state();
  std::vector<Vec3> predicted(mesh_.positions().begin(), mesh_.positions().end());
  const Vec3 axis = random_vector().normalized();
  auto middle = mesh_.vertices().begin();
  std::advance(middle, integer(0, 1U << 30U) % mesh_.vertex_count());
  const Vec3 centre = mesh_.position(*middle) - length_ * random_vector();
  for (Vertex v : mesh_.vertices()) {
    Vec3& x = predicted[v.index()];
    const Vec3 arm = x - centre;
    if (squeezing && arm.norm() < 3 * length_) x -= 0.8 * (arm - arm.dot(axis) * axis);
    if (!squeezing) x += 0.2 * length_ * random_vector();
    if (held_[v] != Hold::none) x = mesh_.position(v);
  }
  context_.reset();
  bool moved = true;
  try {
    std::vector<Hold> held(mesh_.vertex_slots());
    for (Vertex v : mesh_.vertices()) held[v.index()] = held_[v];
    move_safely(mesh_, predicted, held, {.proximity_epsilon = 1e-4 * length_, .zone_passes = 5, .rigid_passes = 5});
  } catch (const CollisionFailure&) {
    moved = false;
  }
  cargo_.measure();
  check(moved, before);
}

void Fuzzer::compact() {
  log_ << "; compact";
  context_.reset();
  mesh_.compact();
  check(true, {});
}

void Fuzzer::check(bool changed, const SurfaceMesh::State& before) {
  ++(changed ? round_.done : round_.refused);
  std::string wrong;
  if (!changed) {
    if (!same_bits(before, mesh_.state())) wrong = "refused, and yet not the same";
  } else if (mesh_.triangle_count() > 0) {
    const std::string report = audit(mesh_, {.closed_regions = start_.closed}).text();
    if (report != "clean") wrong = report;
    if (wrong.empty() && !cargo_.holds()) wrong = "attributes are not what they have to be";
  }
  if (!wrong.empty()) round_.failure = log_.str() + ": " + wrong;
}

}  // namespace

FuzzRound fuzz_operations(std::uint64_t seed, int operations) {
  return Fuzzer(seed).run(operations);
}

}  // namespace lostopos::test
