// The air goes with the films that wires hold: against the dense formulas of the method.
#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <Eigen/Dense>
#include <nlohmann/json.hpp>
#include <numbers>

#include "Base/error.h"
#include "FoamSim/constraints/wire.h"
#include "FoamSim/effects/diffusion.h"
#include "tests/FoamSim/constraints/made_wire.h"
#include "tests/FoamSim/constraints/wired_film.h"
#include "tests/FoamSim/film_parts.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

// The normal of a film at a vertex as the method has it, one region pair there.
Vec3 normal_at(const SurfaceMesh& mesh, Vertex v) {
  Vec3 sum = Vec3::Zero();
  for (Triangle t : mesh.triangles(v)) {
    const auto [a, b, c] = mesh.vertices(t);
    const double sign = mesh.labels(t).p < mesh.labels(t).q ? 1 : -1;
    sum += sign * (mesh.position(b) - mesh.position(a)).cross(mesh.position(c) - mesh.position(a));
  }
  return sum.normalized();
}

double kernel(const Vec3& d) {
  return 1 / (4 * std::numbers::pi * std::pow(d.squaredNorm() + delta * delta, 1.5));
}

// A_ij of the interior solve, written out.
Eigen::MatrixXd interior_matrix(const SurfaceMesh& mesh, const std::vector<Vertex>& held) {
  const auto n = static_cast<Eigen::Index>(held.size());
  Eigen::MatrixXd a = Eigen::MatrixXd::Zero(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      for (Triangle t : mesh.triangles(held[j])) {
        const auto& v = mesh.vertices(t);
        const auto k = static_cast<std::size_t>(std::ranges::find(v, held[j]) - v.begin());
        const Vec3 middle = (mesh.position(v[0]) + mesh.position(v[1]) + mesh.position(v[2])) / 3;
        const Vec3 opposite = mesh.position(v[(k + 2) % 3]) - mesh.position(v[(k + 1) % 3]);
        const double sign = mesh.labels(t).p < mesh.labels(t).q ? 1 : -1;
        const Vec3 d = mesh.position(held[i]) - middle;
        a(i, j) += dt * sign * d.cross(opposite).dot(normal_at(mesh, held[i])) * kernel(d);
      }
  return a;
}

TEST(WireInside, SolvesTheRegularisedLeastSquaresOfTheMethod) {
  constexpr double weight = 0.02;
  WiredFilm film(lostopos::test::globe(1, 6));
  const Vec3 velocity(0.5, 0.2, -0.4);
  const auto constraint =
      made_wire({"x > -0.3 and x < 0.3 and y > -2: move 0.5 0.2 -0.4"}, {.interior_weight = weight});
  constraint->attach(film.tracker);
  const SurfaceMesh& mesh = film.tracker.mesh();
  std::vector<Vertex> held;
  for (Vertex v : mesh.vertices())
    if (std::abs(mesh.position(v).x()) < 0.3) held.push_back(v);
  const auto n = static_cast<Eigen::Index>(held.size());
  ASSERT_GT(n, 10);
  const std::vector<Vec3> before = film.velocities();
  std::vector<double> had;
  had.reserve(held.size());
  for (Vertex v : held) had.push_back(film.circulation.get(v, air_inside));

  const Eigen::MatrixXd a = interior_matrix(mesh, held);
  Eigen::VectorXd b(n);
  for (Eigen::Index i = 0; i < n; ++i) b[i] = dt * (velocity - before[held[i].index()]).dot(normal_at(mesh, held[i]));
  const Eigen::MatrixXd normal = a.transpose() * a + weight * weight * Eigen::MatrixXd::Identity(n, n);
  const Eigen::VectorXd expected = normal.lu().solve(a.transpose() * b);

  const AirChange change = constraint->correct_circulation(film.step(), film.circulation, film.air());
  for (Eigen::Index i = 0; i < n; ++i)
    EXPECT_NEAR(film.circulation.get(held[i], air_inside) - had[static_cast<std::size_t>(i)], expected[i],
                1e-8 * expected.norm());
  EXPECT_LT(change.iterations, n);
  // What is left of the motion along the normal is the residual of the least squares.
  const std::vector<Vec3> after = film.velocities();
  const Eigen::VectorXd left = b - a * expected;
  for (Eigen::Index i = 0; i < n; ++i)
    EXPECT_NEAR(dt * (velocity - after[held[i].index()]).dot(normal_at(mesh, held[i])), left[i], 1e-9);
  EXPECT_LT(left.norm(), b.norm());
  for (Vertex v : mesh.vertices()) EXPECT_EQ(is_held(film.tracker.held()[v]), std::abs(mesh.position(v).x()) < 0.3);
}

// The potential flow around a sphere that moves with speed U: φ = U cos θ R inside, −U cos θ R / 2 outside, so that
// Γ = ¾ U R cos θ in size.
TEST(WireInside, TakesTheAirAroundASphereAlong) {
  WiredFilm film(lostopos::test::globe(1, 12));
  for (Vertex v : film.tracker.mesh().vertices())
    for (PairCirculation& held : film.circulation.at(v)) held.value = 0;
  const auto constraint = made_wire({"x > -2: move 0 2 0"}, {.interior_weight = 1e-5});
  constraint->attach(film.tracker);
  constraint->correct_circulation(film.step(), film.circulation, film.air());
  double product = 0, square = 0;
  for (Vertex v : film.tracker.mesh().vertices()) {
    const double exact = 0.75 * 2 * film.tracker.mesh().position(v).y();
    product += exact * film.circulation.get(v, {lostopos::Region(1), lostopos::Region(0)});
    square += exact * exact;
  }
  // δ of the sheet's regularisation slows the air by about δ/R times the order of the mode; Γ makes up for it.
  EXPECT_NEAR(std::abs(product / square), 1 + 1.5 * delta, 0.15);
}

struct Chain {
  std::vector<Vertex> from, to, third;
};

// The open edges of a tube's two ends, oriented as the tube's triangles are.
Chain open_chain(const SurfaceMesh& mesh) {
  Chain chain;
  for (lostopos::Edge e : mesh.edges()) {
    if (mesh.triangles(e).size() != 1) continue;
    const Triangle t = mesh.triangles(e)[0];
    auto [a, b] = mesh.vertices(e);
    if (mesh.runs_along(t, e) != (mesh.labels(t).p < mesh.labels(t).q)) std::swap(a, b);
    chain.from.push_back(a);
    chain.to.push_back(b);
    chain.third.push_back(mesh.opposite_vertex(t, e));
  }
  return chain;
}

TEST(WireAtOpenEdges, SolvesForVorticesAlongThem) {
  constexpr double weight = 0.01;
  WiredFilm film(lostopos::test::open_cylinder(1, 14, 4, 0.4));
  const auto constraint =
      made_wire({"free-edges: move 0.3 0.5 0.1"}, {.open_boundary = true, .interior_weight = 1, .open_weight = weight});
  constraint->attach(film.tracker);
  const SurfaceMesh& mesh = film.tracker.mesh();
  const Vec3 velocity(0.3, 0.5, 0.1);
  const Chain chain = open_chain(mesh);
  ASSERT_EQ(chain.from.size(), 28U);
  std::map<Vertex, Vec3> normals;
  for (std::size_t k = 0; k < chain.from.size(); ++k) {
    const Vec3 along = mesh.position(chain.to[k]) - mesh.position(chain.from[k]);
    const Vec3 n = along.cross(mesh.position(chain.third[k]) - mesh.position(chain.from[k])).normalized();
    for (Vertex v : {chain.from[k], chain.to[k]}) normals[v] = normals.contains(v) ? Vec3(normals[v] + n) : n;
  }
  const std::vector<Vec3> before = film.velocities();
  const auto n = static_cast<Eigen::Index>(chain.from.size());
  Eigen::MatrixXd b(n, n);
  Eigen::VectorXd right(n);
  const auto segment = [&](std::size_t k, const Vec3& x) {
    const Vec3 &from = mesh.position(chain.from[k]), &to = mesh.position(chain.to[k]);
    const Vec3 d = x - (from + to) / 2;
    return Vec3((to - from).normalized().cross(d) * kernel(d));
  };
  Eigen::Index row = 0;
  for (const auto& [v, sum] : normals) {
    const Vec3 normal = sum.normalized();
    for (Eigen::Index k = 0; k < n; ++k)
      b(row, k) = dt * segment(static_cast<std::size_t>(k), mesh.position(v)).dot(normal);
    right[row++] = dt * (velocity - before[v.index()]).dot(normal);
  }
  const Eigen::VectorXd strengths =
      (b.transpose() * b + weight * weight * Eigen::MatrixXd::Identity(n, n)).lu().solve(b.transpose() * right);

  constraint->correct_circulation(film.step(), film.circulation, film.air());
  std::vector<Vec3> added(mesh.vertex_slots(), Vec3::Zero());
  const EffectStep step = film.step();
  constraint->add_velocity({step, 0, mesh.positions()}, added);
  for (Vertex v : mesh.vertices()) {
    Vec3 expected = Vec3::Zero();
    for (std::size_t k = 0; k < chain.from.size(); ++k)
      expected += strengths[static_cast<Eigen::Index>(k)] * segment(k, mesh.position(v));
    EXPECT_LT((added[v.index()] - expected).norm(), 1e-8 * strengths.norm()) << v.index();
  }
}

}  // namespace
}  // namespace foamsim
