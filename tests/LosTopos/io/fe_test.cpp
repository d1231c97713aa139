#include "LosTopos/io/fe.h"

#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class FeTest : public IoTest {
 protected:
  std::string error_of(const std::string& content) {
    return input_error([&] { read_fe(write("bad.fe", content)); });
  }
};

// What Evolver 2.70 dumps of a tetrahedron with a fixed vertex, a facet of another tension, and body 5, which it gives
// number 1.
const std::string dump = R"(// d.fe: Dump of structure.

// datafilename: t.fe
vertices_predicted         4
facetedges_predicted      13
bodies_predicted           2
quantities_predicted            0
method_instances_predicted      0
// Total energy: 2.86602540378444
SOAPFILM

LINEAR

SCALE: 0.271312749192785

VIEW_MATRIX 
 2.000000000000000   0.000000000000000   0.000000000000000  -1.000000000000000  
 0.000000000000000   2.000000000000000   0.000000000000000  -1.000000000000000  
slice_coeff = { 1.00000, 0.00000, 0.00000, 0.50000}


vertices        /*  coordinates  */    
  1                  0                 0                 0 fixed 
  2                  1                 0                 0
  3                  0                 1                 0 
  4                  0                 0                 1 original 7

edges  
  1       1    2    fixed 
  2       2    3    
  3       3    1    
  4       1    4     original 4
  5       2    4    
  6       3    4    

faces    /* edge loop */      
  1   -3 -2 -1  density 2.5  /*area 0.5*/
  2   1 5 -4 color red  /*area 0.5*/
  3   2 6 -5 fixed  /*area 0.866025403784439*/
  4   3 4 -6 /*area 0.5*/ original 9

bodies  /* facets */
  1       1 2 \
           3 4  volume 0.2  /*actual: 0.166666666666667*/ lagrange_multiplier 0  centerofmass  original 5

read

metric_conversion off
)";

TEST_F(FeTest, RoundTripKeepsEveryBitAndTheOrder) {
  SurfaceData data = two_tetrahedra();
  std::swap(data.triangles[1], data.triangles[5]);  // labels alternate
  std::swap(data.labels[1], data.labels[5]);
  write_fe(path("a.fe"), data);
  expect_same_surface(read_fe(path("a.fe")), data);
  EXPECT_TRUE(read_fe(path("a.fe")).held.empty());
  write_fe(path("empty.fe"), {});
  EXPECT_EQ(read_fe(path("empty.fe")), SurfaceData{});
}

TEST_F(FeTest, BodiesHaveTheirVolumes) {
  SurfaceData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, -1}};
  data.triangles = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}, {0, 1, 4}, {1, 2, 4}, {2, 0, 4}};
  const Region two{2}, seven{7};
  data.labels = {{seven, two}, {seven, air}, {seven, air}, {seven, air}, {air, two}, {air, two}, {air, two}};
  write_fe(path("a.fe"), data);
  expect_contains(content_of(path("a.fe")), "\n2 -1 -5 -6 -7 volume 0.1666666666666666");
  expect_contains(content_of(path("a.fe")), "\n7 1 2 3 4 volume 0.1666666666666666");
  expect_same_surface(read_fe(path("a.fe")), data);
}

TEST_F(FeTest, FreeEdgesHeldVerticesAndSolidsAreFixed) {
  SurfaceData data = two_tetrahedra();
  data.held = {{3, data.positions[3]}};
  write_fe(path("held.fe"), data);
  EXPECT_EQ(read_fe(path("held.fe")).held, data.held);
  data.held.clear();
  data.triangle_arrays = {{"solid", 1, {1, 0, 0, 0, 0, 0, 0}}};
  write_fe(path("solid.fe"), data);
  const SurfaceData solid = read_fe(path("solid.fe"));
  ASSERT_EQ(solid.held.size(), 3U);
  EXPECT_EQ(solid.held[2].vertex, 3U);
  EXPECT_EQ(solid.triangle_arrays, (std::vector<DataArray>{{"tension", 1, {0, 1, 1, 1, 1, 1, 1}}}));
  data.triangle_arrays.clear();
  data.triangles.pop_back();
  data.labels.pop_back();
  write_fe(path("open.fe"), data);
  EXPECT_EQ(read_fe(path("open.fe")).held.size(), 3U);
  expect_contains(content_of(path("open.fe")), "volume");
}

TEST_F(FeTest, TensionsAreAnArrayOfTriangles) {
  SurfaceData data = two_tetrahedra();
  data.triangle_arrays = {{"tension", 1, {1, 2, 0.1, 1, 0, 1, 1}}};
  write_fe(path("a.fe"), data);
  EXPECT_EQ(read_fe(path("a.fe")).triangle_arrays, data.triangle_arrays);
  data.triangle_arrays[0].values[3] = -1;
  expect_contains(input_error([&] { write_fe(path("b.fe"), data); }), "array 'tension'");
  EXPECT_EQ(files_in_folder(), 1U);
}

TEST_F(FeTest, ReadsWhatEvolverDumps) {
  const SurfaceData data = read_fe(write("dump.fe", dump));
  EXPECT_EQ(data.positions, (std::vector<Vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}));
  EXPECT_EQ(data.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}));
  EXPECT_EQ(data.labels, std::vector<Labels>(4, Labels{Region{5}, air}));
  EXPECT_EQ(data.held, (std::vector<HeldVertex>{{0, {0, 0, 0}}}));
  EXPECT_EQ(data.triangle_arrays, (std::vector<DataArray>{{"tension", 1, {2.5, 1, 1, 1}}}));
}

TEST_F(FeTest, ReadsWhatPeopleWrite) {
  const std::string triangle = "VERTICES\r\n10, 0 0 0\n20: 1 0 0 /* not\nthe end */ FIXED\n7 0 1 0 // last\n\nEdges\n";
  const SurfaceData plain = read_fe(write("a.fe", triangle + "1 10 20\n2 20 7\n3 7 10\nfacets\n1 1 2 3"));
  EXPECT_EQ(plain.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_EQ(plain.labels, std::vector<Labels>{default_labels}) << "no bodies";
  EXPECT_EQ(plain.held.size(), 1U);
  const SurfaceData turned = read_fe(write(
      "b.fe", triangle + "3 7 10\n1 10 20\n2 7 20\nfaces\n4 -2 3 1 backbody 3 frontbody 1\nbodies\n1\n3 \\\r\n 4\n"));
  EXPECT_EQ(turned.triangles, (std::vector<std::array<std::uint32_t, 3>>{{1, 2, 0}}));
  EXPECT_EQ(turned.labels, (std::vector<Labels>{{Region{3}, Region{1}}}));
}

TEST_F(FeTest, ErrorsNameTheLine) {
  const auto wrong = [&](const std::string& from, const std::string& to) { return error_of(replaced(dump, from, to)); };
  expect_contains(error_of(""), "line 1: the file ends before its facets");
  expect_contains(error_of("vertices\n1 0 0 0\nread\n"), "line 3: the file ends before its facets");
  expect_contains(wrong("4                  0 ", "4 2*x"), "line 26: '2*x' stands where a coordinate should");
  expect_contains(wrong("0 fixed", "inf fixed"), "line 23: the position is (0, 0, inf)");
  expect_contains(wrong("  4                  0", "  3                  0"), "line 26: vertex 3 is there before");
  expect_contains(wrong("2       2    3", "2       2    9"), "line 30: vertex 9 does not exist");
  expect_contains(wrong("2       2    3", "2       2    2"), "line 30: the edge ends at the vertex");
  expect_contains(wrong("2       2    3", "x       2    3"), "line 30: 'x' stands where the number of the next edge");
  expect_contains(wrong("3 4 -6", "3 4 9"), "line 40: edge 9 does not exist");
  expect_contains(wrong("3 4 -6", "3 4 -9223372036854775808"), "does not exist");
  expect_contains(wrong("3 4 -6", "3 4 6"), "line 40: the facet's edges do not follow each other");
  expect_contains(wrong("3 4 -6", "3 4 5"), "line 40: the facet's edges do not follow each other");
  expect_contains(wrong("1 5 -4", "1 5 -6 3"), "line 38: the facet has more than three edges; let Evolver");
  expect_contains(wrong("1 5 -4", "1 5 -6"), "line 38: the facet's three edges do not close");
  expect_contains(wrong("density 2.5", "density -1"), "line 37: a tension has to be");
  expect_contains(wrong("3 4  volume", "3  volume"), "line 40: the facet belongs to no body");
  expect_contains(wrong("3 4  volume", "3 4 -4  volume"), "line 40: the triangle's labels are (5, 5)");
  expect_contains(wrong("3 4  volume", "3 4 11  volume"), "line 44: facet 11 does not exist");
  expect_contains(wrong("original 5", "original 5\n2 4"),
                  "line 45: a facet would have two bodies on one side, 1 and 2");
  expect_contains(wrong("original 5", "original 5\n1"), "line 45: a body is number 1");
  expect_contains(wrong("original 5", "original 5\n2 original 5"), "line 45: a body is number 5");
  expect_contains(wrong("fixed  /*", "frontbody 8 /*"), "line 39: the facet's body 8 does not exist");
  expect_contains(wrong("original 5", "original 0"), "line 44: a body's original number cannot be 0");
  expect_contains(wrong("\nread", "\nedges"), "line 46: 'edges' stands here; vertices, edges, faces, bodies");
  expect_contains(wrong("/*  coordinates  */", "of mine"), "line 22: the line should end behind 'vertices'");
  expect_contains(error_of("vertices\n1 0 0 0 /* x"), "line 2: the comment that begins here has no end");
}

TEST_F(FeTest, WhatNoSurfaceHereHasIsRefused) {
  const auto wrong = [&](const std::string& from, const std::string& to) { return error_of(replaced(dump, from, to)); };
  const auto declared = [&](const std::string& line) { return wrong("LINEAR", line); };
  expect_contains(declared("constraint 1 convex\nformula: x^2 + y^2 = 1"), "line 12: 'constraint' has no place");
  expect_contains(declared("Boundary 1 parameters 1"), "line 12: 'boundary' has no place in a surface: there are no");
  expect_contains(declared("TORUS_FILLED"), "line 12: 'torus_filled' has no place in a surface: space is open");
  expect_contains(declared("periods\n1 0 0\n"), "line 12: 'periods'");
  expect_contains(declared("STRING"), "line 12: 'string' has no place in a surface: facets are plain triangles");
  expect_contains(declared("quadratic"), "plain triangles");
  expect_contains(declared("space_dimension 2"), "three dimensions");
  expect_contains(declared("quantity q energy method facet_area"), "no energy here but tension");
  expect_contains(declared("#define R 2"), "let Evolver read this file and dump it");
  expect_contains(declared("gravitas 7"), "line 12: 'gravitas' is no declaration that is known here");
  EXPECT_EQ(read_fe(write("three.fe", replaced(dump, "LINEAR", "space_dimension 3"))), read_fe(write("d.fe", dump)));
  expect_contains(wrong("original 7", "constraint 1"), "line 26: 'constraint' has no place");
  expect_contains(wrong("original 7", "velocity"),
                  "'velocity' is no attribute of the vertex that is known here; known");
  expect_contains(wrong("original 4", "tension 1"), "line 32: 'tension' has no place");
  expect_contains(wrong("volume 0.2", "pressure 2"), "line 44: 'pressure' has no place in a surface: bodies keep");
  expect_contains(wrong("volume 0.2", "density 1"), "line 44: 'density'");
  EXPECT_TRUE(read_fe(write("zero.fe", replaced(dump, "volume 0.2", "density 0"))).held.size() == 1);
  expect_contains(wrong("original 9", "original"),
                  "line 40: the line ends where the value of 'original' should follow");
}

}  // namespace
}  // namespace lostopos
