// Continuous collision detection: time for one query, by kind of query.
#include <benchmark/benchmark.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "LosTopos/geometry/ccd.h"

namespace {

using lostopos::Trajectory;
using lostopos::Vec3;
using Query = std::array<Trajectory, 4>;

enum class Kind {
  far,        // boxes of the motions overlap, the shapes stay about their size apart
  near_miss,  // shapes move together and turn by a few degrees, some percent of their size apart: the tracker's case
  hit,        // one shape passes through the other
};

class Queries {
 public:
  Queries(Kind kind, bool edges) {
    for (Query& q : queries_) q = make(kind, edges);
  }

  const Query& operator[](std::size_t i) const { return queries_[i % queries_.size()]; }

 private:
  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(bits_); }
  Vec3 vector(double size) {
    const double x = uniform(-size, size);
    const double y = uniform(-size, size);
    return {x, y, uniform(-size, size)};
  }

  // A vertex over a triangle or an edge over another, `gap` above it, then displaced: turned together, or shifted.
  Query make(Kind kind, bool edges) {
    const Eigen::Quaterniond frame = Eigen::Quaterniond::UnitRandom();
    const double gap = kind == Kind::far ? uniform(1, 2) : kind == Kind::near_miss ? uniform(0.02, 0.2) : 0.2;
    std::array<Vec3, 4> x;
    if (edges) {
      x = {Vec3(-0.5, 0.1, gap), Vec3(0.5, -0.2, gap), Vec3(0, -0.5, 0), Vec3(0.1, 0.5, 0)};
    } else {
      x = {Vec3(0, 0, gap), Vec3(-0.5, -0.3, 0), Vec3(0.5, -0.3, 0), Vec3(0, 0.6, 0)};
    }
    const Eigen::AngleAxisd turn(uniform(0, 0.1), vector(1).normalized());
    const Vec3 shift = vector(0.3);
    Query q;
    for (std::size_t i = 0; i < 4; ++i) {
      Vec3 end = turn * x[i] + shift + vector(0.01);
      if (kind == Kind::hit && i < (edges ? 2U : 1U)) end.z() -= 0.5;
      q[i] = {frame * x[i], frame * end};
    }
    return q;
  }

  std::mt19937_64 bits_{1};
  std::vector<Query> queries_ = std::vector<Query>(4096);
};

void run(benchmark::State& state, Kind kind, bool edges) {
  const Queries queries(kind, edges);
  std::size_t i = 0;
  std::size_t hits = 0;
  for (auto _ : state) {
    const Query& q = queries[i++];
    const auto collision = edges ? lostopos::edge_edge_collision(q[0], q[1], q[2], q[3])
                                 : lostopos::vertex_triangle_collision(q[0], q[1], q[2], q[3]);
    hits += collision ? 1 : 0;
    benchmark::DoNotOptimize(hits);
  }
  state.counters["hits"] = static_cast<double>(hits) / static_cast<double>(i);
}

BENCHMARK_CAPTURE(run, vertex_triangle_far, Kind::far, false);
BENCHMARK_CAPTURE(run, vertex_triangle_near_miss, Kind::near_miss, false);
BENCHMARK_CAPTURE(run, vertex_triangle_hit, Kind::hit, false);
BENCHMARK_CAPTURE(run, edge_edge_far, Kind::far, true);
BENCHMARK_CAPTURE(run, edge_edge_near_miss, Kind::near_miss, true);
BENCHMARK_CAPTURE(run, edge_edge_hit, Kind::hit, true);

}  // namespace

BENCHMARK_MAIN();
