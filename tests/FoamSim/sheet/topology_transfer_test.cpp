// Γ through merges and separations, against the rules themselves: the mesh is changed by hand, the events are made
// here.
#include <gtest/gtest.h>

#include "FoamSim/sheet/circulation.h"
#include "tests/FoamSim/sheet/values_at.h"
#include "tests/support/film_meshes.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::air;
using lostopos::Edge;
using lostopos::Labels;
using lostopos::MergeEvent;
using lostopos::OperationObserver;
using lostopos::Place;
using lostopos::Region;
using lostopos::SeparationEvent;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

constexpr Region one{1}, two{2};
constexpr Labels out_of_one{one, air}, out_of_two{two, air}, wall{one, two};

// A different value for every vertex and pair.
double mark(Vertex v, RegionPair pair) {
  return 1 + v.index() + 0.1 * pair.low.index() + 0.01 * pair.high.index();
}

void set_marks(const SurfaceMesh& mesh, CirculationField& circulation) {
  for (Vertex v : mesh.vertices())
    for (PairCirculation& held : circulation.at(v)) held.value = mark(v, held.pair);
}

Place at(Vertex v) {
  return {{v}, {1.0}, 1};
}

// Gives the triangles of `from` that `moves` picks to `to`, as merging and separating do.
template <class Pick>
void hand_over(SurfaceMesh& mesh, Vertex from, Vertex to, const Pick& moves) {
  const std::vector<Triangle> star(mesh.triangles(from).begin(), mesh.triangles(from).end());
  for (Triangle t : star) {
    if (!moves(t)) continue;
    auto v = mesh.vertices(t);
    const Labels labels = mesh.labels(t);
    std::ranges::replace(v, from, to);
    mesh.remove_triangle(t);
    mesh.add_triangle(v[0], v[1], v[2], labels);
  }
}

// Two tetrahedra, regions 1 and 2 in the air, whose first corners are near each other.
struct TwoTetrahedra {
  TwoTetrahedra() {
    lostopos::test::add_corner_tetrahedron(mesh, 1, Vec3::Zero(), one, air);
    lostopos::test::add_corner_tetrahedron(mesh, -1, Vec3(-0.01, 0, 0), two, air);
    circulation = std::make_unique<CirculationField>(mesh);
    set_marks(mesh, *circulation);
  }
  SurfaceMesh mesh;
  std::unique_ptr<CirculationField> circulation;
  Vertex a{0}, b{4};
};

TEST(MergeTransfer, KeepsAPairThatOnePlaceHadAsItWas) {
  TwoTetrahedra two_bodies;
  auto& [mesh, circulation, a, b] = two_bodies;
  const double of_a = mark(a, RegionPair(out_of_one)), of_b = mark(b, RegionPair(out_of_two));
  MergeEvent event{{at(a), at(b)}, 0.3, a, Vec3::Zero(), {}, {}};
  mesh.carry_attributes(&OperationObserver::before_merge, event);
  hand_over(mesh, b, a, [](Triangle) { return true; });
  mesh.remove_vertex(b);
  mesh.carry_attributes(&OperationObserver::after_merge, event);
  EXPECT_EQ(values_at(*circulation, a), (Values{{RegionPair(out_of_one), of_a}, {RegionPair(out_of_two), of_b}}))
      << "how far the result lies from a vertex does not matter to a pair that only this one has";
}

TEST(MergeTransfer, OfPlacesInsideAnEdgeAndATriangleMixesTheirMeans) {
  SurfaceMesh mesh = lostopos::test::analytic_double_bubble(1, 12);
  CirculationField circulation(mesh);
  set_marks(mesh, circulation);
  // An edge from the border to the left cap, and a triangle of the left cap.
  Vertex border, film;
  Triangle inner;
  for (Triangle t : mesh.triangles()) {
    if (RegionPair(mesh.labels(t)) != RegionPair(out_of_one)) continue;
    const auto& v = mesh.vertices(t);
    if (mesh.is_junction(v[0]) && !mesh.is_junction(v[1])) border = v[0], film = v[1];
    if (!mesh.is_junction(v[0]) && !mesh.is_junction(v[1]) && !mesh.is_junction(v[2])) inner = t;
  }
  ASSERT_TRUE(border.valid() && inner.valid());
  const auto corner = mesh.vertices(inner);
  const std::array<Place, 2> places{Place{{border, film}, {0.25, 0.75}, 2}, Place{corner, {0.2, 0.3, 0.5}, 3}};
  const RegionPair shared(out_of_one);
  const double first = 0.25 * mark(border, shared) + 0.75 * mark(film, shared);
  const double second = 0.2 * mark(corner[0], shared) + 0.3 * mark(corner[1], shared) + 0.5 * mark(corner[2], shared);
  const MergeEvent event{places, 0.4, border, Vec3::Zero(), {}, {}};
  mesh.carry_attributes(&OperationObserver::before_merge, event);
  mesh.carry_attributes(&OperationObserver::after_merge, event);
  const Values mixed = values_at(circulation, border);
  ASSERT_EQ(mixed.size(), 3U);
  EXPECT_NEAR(mixed.at(shared), 0.6 * first + 0.4 * second, 1e-13);
  for (Labels only_at_border : {out_of_two, wall})
    EXPECT_NEAR(mixed.at(RegionPair(only_at_border)), mark(border, RegionPair(only_at_border)), 1e-13)
        << "the mean goes over the vertices that hold the pair";
}

// Films (1, 0) and (0, 2) on the same three corners, which become a wall (1, 2).
struct PressedFilms {
  PressedFilms() {
    for (const Vec3& x : {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(0, 0, -1)})
      mesh.add_vertex(x);
    const std::array<Vertex, 3> c{Vertex(0), Vertex(1), Vertex(2)};
    upper = mesh.add_triangle(c[0], c[1], c[2], {one, air});
    lower = mesh.add_triangle(c[0], c[1], c[2], {air, two});
    for (std::size_t i = 0; i < 3; ++i) {
      mesh.add_triangle(c[(i + 1) % 3], c[i], Vertex(3), out_of_one);
      mesh.add_triangle(c[i], c[(i + 1) % 3], Vertex(4), out_of_two);
    }
  }
  void cancel() {
    mesh.remove_triangle(lower);
    mesh.set_labels(upper, wall);
  }
  MergeEvent event() const { return {{at(Vertex(0)), at(Vertex(0))}, 0, Vertex(0), Vec3::Zero(), {}, {}}; }
  SurfaceMesh mesh;
  Triangle upper, lower;
};

TEST(MergeTransfer, TheFirstTriangleOfANewWallTakesTheSumOfThePotentialJumps) {
  PressedFilms films;
  CirculationField circulation(films.mesh);
  set_marks(films.mesh, circulation);
  films.mesh.carry_attributes(&OperationObserver::before_merge, films.event());
  films.cancel();
  films.mesh.carry_attributes(&OperationObserver::after_merge, films.event());
  for (Vertex v : {Vertex(0), Vertex(1), Vertex(2)}) {
    const double sum = -mark(v, RegionPair(out_of_one)) + mark(v, RegionPair(out_of_two));  // Γ^{10} + Γ^{02}
    EXPECT_NEAR(circulation.get(v, wall), sum, 1e-14);
    EXPECT_EQ(circulation.get(v, {air, one}), mark(v, RegionPair(out_of_one)));
  }
}

TEST(MergeTransfer, AWallThatGrowsTakesTheMeanOfTheNeighboursThatHoldIt) {
  PressedFilms films;
  const Vertex beside = films.mesh.add_vertex({1, 1, 0});
  films.mesh.add_triangle(Vertex(1), beside, Vertex(2), wall);  // corners 1 and 2 hold the wall's pair already
  CirculationField circulation(films.mesh);
  set_marks(films.mesh, circulation);
  films.mesh.carry_attributes(&OperationObserver::before_merge, films.event());
  films.cancel();
  films.mesh.carry_attributes(&OperationObserver::after_merge, films.event());
  const RegionPair pair(wall);
  EXPECT_NEAR(circulation.get(Vertex(0), wall), (mark(Vertex(1), pair) + mark(Vertex(2), pair)) / 2, 1e-14);
  EXPECT_EQ(circulation.get(Vertex(1), wall), mark(Vertex(1), pair));
}

TEST(MergeTransfer, LeavesNoPairBehindWhereARegionIsGone) {
  PressedFilms films;
  CirculationField circulation(films.mesh);
  films.mesh.carry_attributes(&OperationObserver::before_merge, films.event());
  for (Triangle t : std::vector<Triangle>(films.mesh.triangles().begin(), films.mesh.triangles().end()))
    if (films.mesh.labels(t).has(two)) films.mesh.remove_triangle(t);
  films.mesh.remove_vertex(Vertex(4));
  films.mesh.carry_attributes(&OperationObserver::after_merge, films.event());
  for (Vertex v : films.mesh.vertices()) {
    ASSERT_EQ(circulation.at(v).size(), 1U);
    EXPECT_EQ(circulation.at(v)[0].pair, RegionPair(out_of_one));
  }
}

TEST(SeparationTransfer, BothCopiesKeepTheValuesOfThePairsTheyHave) {
  TwoTetrahedra two_bodies;
  auto& [mesh, unused, a, b] = two_bodies;
  unused.reset();
  hand_over(mesh, b, a, [](Triangle) { return true; });  // two bodies that touch in a point
  CirculationField circulation(mesh);
  set_marks(mesh, circulation);
  mesh.carry_attributes(&OperationObserver::before_separation,
                        SeparationEvent{a, Vertex(), Vec3::Zero(), Vec3::Zero(), {}});
  const Vertex added = mesh.add_vertex(Vec3(-0.01, 0, 0));
  hand_over(mesh, a, added, [&mesh = mesh](Triangle t) { return mesh.labels(t).has(two); });
  mesh.carry_attributes(&OperationObserver::after_separation,
                        SeparationEvent{a, added, Vec3::Zero(), Vec3::Zero(), {}});
  EXPECT_EQ(values_at(circulation, a), (Values{{RegionPair(out_of_one), mark(a, RegionPair(out_of_one))}}));
  EXPECT_EQ(values_at(circulation, added), (Values{{RegionPair(out_of_two), mark(a, RegionPair(out_of_two))}}));
}

TEST(SeparationTransfer, ANeighbourThatGainsAPairTakesTheValueOfTheVertex) {
  SurfaceMesh mesh = lostopos::test::analytic_double_bubble(1, 12);
  CirculationField circulation(mesh);
  set_marks(mesh, circulation);
  Vertex border, film;  // the end of an edge that is swept to a film between 1 and 2
  for (Triangle t : mesh.triangles())
    if (RegionPair(mesh.labels(t)) == RegionPair(out_of_one))
      for (int i = 0; i < 3; ++i)
        if (mesh.is_junction(mesh.vertices(t)[i]) && !mesh.is_junction(mesh.vertices(t)[(i + 1) % 3]))
          border = mesh.vertices(t)[i], film = mesh.vertices(t)[(i + 1) % 3];
  const Values before = values_at(circulation, border), film_before = values_at(circulation, film);
  ASSERT_EQ(before.size(), 3U);
  ASSERT_FALSE(film_before.contains(RegionPair(wall)));
  mesh.carry_attributes(&OperationObserver::before_separation,
                        SeparationEvent{border, Vertex(), Vec3::Zero(), Vec3::Zero(), {}});
  const Vertex added = mesh.add_vertex(mesh.position(border) + Vec3(0, 0, 0.1));
  mesh.add_triangle(border, added, film, wall);
  mesh.carry_attributes(&OperationObserver::after_separation,
                        SeparationEvent{border, added, Vec3::Zero(), Vec3::Zero(), {}});
  EXPECT_EQ(circulation.get(film, wall), before.at(RegionPair(wall)));
  EXPECT_EQ(circulation.get(added, wall), before.at(RegionPair(wall)));
  EXPECT_EQ(values_at(circulation, border), before);
  EXPECT_EQ(values_at(circulation, film).at(RegionPair(out_of_one)), film_before.at(RegionPair(out_of_one)));
}

TEST(SeparationTransfer, APairThatIsNewBetweenTheCopiesIsTheSumOfThePotentialJumps) {
  TwoTetrahedra two_bodies;
  auto& [mesh, unused, a, b] = two_bodies;
  unused.reset();
  hand_over(mesh, b, a, [](Triangle) { return true; });
  CirculationField circulation(mesh);
  set_marks(mesh, circulation);
  mesh.carry_attributes(&OperationObserver::before_separation,
                        SeparationEvent{a, Vertex(), Vec3::Zero(), Vec3::Zero(), {}});
  const Vertex added = mesh.add_vertex(Vec3(-0.01, 0, 0));
  mesh.add_triangle(a, added, Vertex(1), wall);
  mesh.carry_attributes(&OperationObserver::after_separation,
                        SeparationEvent{a, added, Vec3::Zero(), Vec3::Zero(), {}});
  const double sum = -mark(a, RegionPair(out_of_one)) + mark(a, RegionPair(out_of_two));
  EXPECT_NEAR(circulation.get(a, wall), sum, 1e-14);
  EXPECT_NEAR(circulation.get(added, wall), sum, 1e-14);
  EXPECT_NEAR(circulation.get(Vertex(1), wall), sum, 1e-14) << "the neighbour follows: no jump along the film";
}

}  // namespace
}  // namespace foamsim
