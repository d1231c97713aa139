// Wires that hold several films at one vertex: each goes along, and circulation is closed round Plateau borders.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "FoamSim/constraints/wire_films.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/free_junctions.h"
#include "LosTopos/shapes/triple_junction.h"
#include "tests/FoamSim/constraints/wired_film.h"

namespace foamsim {
namespace {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vec3;
using lostopos::Vertex;

std::vector<std::uint8_t> held_in(const WiredFilm& film) {
  std::vector<std::uint8_t> held;
  for (lostopos::Hold hold : film.tracker.held().slots()) held.push_back(is_held(hold) ? 1 : 0);
  return held;
}

// The largest difference, in the direction of any film at a held vertex, of the air's velocity from the wire's.
double worst(WiredFilm& film, const Vec3& velocity) {
  const std::vector<Vec3> air = film.velocities();
  double worst = 0;
  for (const HeldFilm& held : WireFilms(film.step(), held_in(film)).inside)
    worst = std::max(worst, std::abs((velocity - air[held.vertex.index()]).dot(held.normal)));
  return worst;
}

using Values = std::vector<std::vector<PairCirculation>>;

Values values_of(const WiredFilm& film) {
  Values values(film.tracker.mesh().vertex_slots());
  for (Vertex v : film.tracker.mesh().vertices()) {
    const auto at = film.circulation.at(v);
    values[v.index()].assign(at.begin(), at.end());
  }
  return values;
}

struct Loops {
  std::size_t count = 0;
  double largest = 0;  // sum of the changes of Γ round one of them
  double change = 0;   // the largest of one pair
};

// Round the borders of three films each, at vertices that have all three.
Loops changes_round_borders(const WiredFilm& film, const Values& before) {
  Loops loops;
  for (Vertex v : film.tracker.mesh().vertices()) {
    std::map<RegionPair, double> change;
    const auto now = film.circulation.at(v);
    for (std::size_t i = 0; i < now.size(); ++i) change[now[i].pair] = now[i].value - before[v.index()][i].value;
    for (const auto& [pq, of_pq] : change) {
      loops.change = std::max(loops.change, std::abs(of_pq));
      for (const auto& [qr, of_qr] : change) {
        const auto pr = change.find(RegionPair(pq.low, qr.high));
        if (qr.low != pq.high || pr == change.end()) continue;
        ++loops.count;
        loops.largest = std::max(loops.largest, std::abs(of_pq + of_qr - pr->second));
      }
    }
  }
  return loops;
}

struct Case {
  std::string name;
  SurfaceMesh (*mesh)();
  std::string held;
  std::size_t fewest_loops;
};

class WireAtBorders : public testing::TestWithParam<Case> {};

TEST_P(WireAtBorders, TakesEveryFilmAlongWithClosedCirculation) {
  WiredFilm film(GetParam().mesh());
  const Vec3 velocity(0.3, 0.2, 0.4);
  const auto constraint = made_wire({GetParam().held + ": move 0.3 0.2 0.4"}, {.interior_weight = 1e-4});
  constraint->attach(film.tracker);
  const double worst_before = worst(film, velocity);
  const Values before = values_of(film);
  constraint->correct_circulation(film.step(), film.circulation, film.air());
  EXPECT_GT(worst_before, 0.1);
  EXPECT_LT(worst(film, velocity), 0.05 * worst_before);
  const Loops loops = changes_round_borders(film, before);
  EXPECT_GE(loops.count, GetParam().fewest_loops);
  EXPECT_GT(loops.change, 0.01);
  EXPECT_LT(loops.largest, 1e-11 * loops.change);
}

SurfaceMesh border_mesh() {
  return lostopos::triple_junction({120, 120, 120}).mesh;
}

INSTANTIATE_TEST_SUITE_P(
    Films, WireAtBorders,
    testing::Values(Case{"border", &border_mesh, "x > -0.5 and x < 0.5", 1},
                    Case{"plateau_vertex", +[] { return free_quad_junction(2); },
                         "x > -0.9 and x < -0.5 and y > -0.2 and y < 0.2 and z > -0.7 and z < -0.3", 4},
                    Case{"two_bubbles", +[] { return double_bubble(12, 12); }, "z > -0.1 and z < 0.1", 2}),
    [](const auto& info) { return info.param.name; });

// What circulation 1 of each film does to all, over a step along their normals: the velocities are linear in it.
Eigen::MatrixXd motion_by_unit(WiredFilm& film, const std::vector<HeldFilm>& films) {
  const auto n = static_cast<Eigen::Index>(films.size());
  Eigen::MatrixXd motion(n, n);
  for (Vertex v : film.tracker.mesh().vertices())
    for (PairCirculation& held : film.circulation.at(v)) held.value = 0;
  for (Eigen::Index j = 0; j < n; ++j) {
    const HeldFilm& source = films[static_cast<std::size_t>(j)];
    film.circulation.set(source.vertex, {source.pair.low, source.pair.high}, 1);
    const std::vector<Vec3> air = film.velocities();
    film.circulation.set(source.vertex, {source.pair.low, source.pair.high}, 0);
    for (Eigen::Index i = 0; i < n; ++i) {
      const HeldFilm& at = films[static_cast<std::size_t>(i)];
      motion(i, j) = dt * air[at.vertex.index()].dot(at.normal);
    }
  }
  return motion;
}

// One row for each vertex with the films (0, 1), (0, 2) and (1, 2).
Eigen::MatrixXd borders_of(const std::vector<HeldFilm>& films) {
  std::map<Vertex, Eigen::RowVectorXd> rows;
  for (std::size_t i = 0; i < films.size(); ++i) {
    auto& row = rows.try_emplace(films[i].vertex, Eigen::RowVectorXd::Zero(static_cast<Eigen::Index>(films.size())))
                    .first->second;
    const bool goes_back = films[i].pair == RegionPair(Region(0), Region(2));
    row[static_cast<Eigen::Index>(i)] = goes_back ? -1 : 1;
  }
  std::erase_if(rows, [](const auto& row) { return row.second.cwiseAbs().sum() < 2.5; });
  Eigen::MatrixXd borders(static_cast<Eigen::Index>(rows.size()), static_cast<Eigen::Index>(films.size()));
  Eigen::Index r = 0;
  for (const auto& [v, row] : rows) borders.row(r++) = row;
  return borders;
}

TEST(WireInside, SolvesTheLeastSquaresOfClosedChanges) {
  constexpr double weight = 0.002;
  // At equal angles they would be closed by symmetry.
  WiredFilm film(lostopos::triple_junction({90, 110, 160}).mesh);
  const auto constraint = made_wire({"x > -1.5 and x < 1.5: move 0 0.3 0.4"}, {.interior_weight = weight});
  constraint->attach(film.tracker);
  const std::vector<HeldFilm> films = WireFilms(film.step(), held_in(film)).inside;
  const Eigen::MatrixXd motion = motion_by_unit(film, films), borders = borders_of(films);
  ASSERT_EQ(borders.rows(), 3);
  const Eigen::Index n = motion.rows(), all = n + borders.rows();
  // The air is at rest now.
  Eigen::MatrixXd system = Eigen::MatrixXd::Zero(all, all);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(all), b(n);
  for (Eigen::Index i = 0; i < n; ++i) b[i] = dt * Vec3(0, 0.3, 0.4).dot(films[static_cast<std::size_t>(i)].normal);
  system.topLeftCorner(n, n) = motion.transpose() * motion + weight * weight * Eigen::MatrixXd::Identity(n, n);
  system.bottomLeftCorner(borders.rows(), n) = borders;
  system.topRightCorner(n, borders.rows()) = borders.transpose();
  right.head(n) = motion.transpose() * b;
  const Eigen::VectorXd expected = system.fullPivLu().solve(right).head(n);

  constraint->correct_circulation(film.step(), film.circulation, film.air());
  for (std::size_t i = 0; i < films.size(); ++i)
    EXPECT_NEAR(film.circulation.get(films[i].vertex, {films[i].pair.low, films[i].pair.high}),
                expected[static_cast<Eigen::Index>(i)], 1e-7 * expected.norm());
}

// Half of the neighbourhood of a vertex on a wire: the film (0, 1) ends there, and a bubble, 2, sits on it at the
// vertex alone.
struct BubbleAtWire {
  BubbleAtWire() {
    at = mesh.add_vertex(Vec3::Zero());
    left = mesh.add_vertex({-1, 0, 0});
    right = mesh.add_vertex({1, 0, 0});
    const Vertex first = mesh.add_vertex({-0.5, 0.8, 0}), second = mesh.add_vertex({0.5, 0.8, 0});
    const Vertex top = mesh.add_vertex({0, 0.7, 0.5}), bottom = mesh.add_vertex({0, 0.7, -0.5});
    const Region above(0), below(1), bubble(2);
    mesh.add_triangle(at, left, first, {above, below});
    mesh.add_triangle(at, second, right, {above, below});
    mesh.add_triangle(at, first, top, {above, bubble});
    mesh.add_triangle(at, top, second, {above, bubble});
    mesh.add_triangle(at, first, bottom, {bubble, below});
    mesh.add_triangle(at, bottom, second, {bubble, below});
  }
  SurfaceMesh mesh;
  Vertex at, left, right;
};

TEST(WireAtOpenEdges, LeavesFilmsThatDoNotEndThereInside) {
  BubbleAtWire bubble;
  const Vertex at = bubble.at;
  std::vector<std::uint8_t> wired(bubble.mesh.vertex_slots(), 0);
  for (Vertex v : {at, bubble.left, bubble.right}) wired[v.index()] = 1;
  WiredFilm film(std::move(bubble.mesh));
  const WireFilms films(film.step(), wired);
  EXPECT_EQ(films.open_edges.size(), 2U);
  EXPECT_EQ(films.at_open_edges.size(), 3U);
  ASSERT_EQ(films.inside.size(), 2U);
  EXPECT_EQ(films.inside[0].vertex, at);
  EXPECT_EQ(films.inside[1].vertex, at);
  // Γ of the film that ends stays, so that both others have to change alike, both towards the bubble.
  Eigen::VectorXd change(2);
  change << 1, 0;
  ClosedCirculation(film.step(), films.inside).project(change);
  EXPECT_NEAR(change[0], 0.5, 1e-12);
  EXPECT_NEAR(change[1], 0.5, 1e-12);
}

}  // namespace
}  // namespace foamsim
