#include "LosTopos/io/obj.h"

#include "LosTopos/shapes/solids.h"
#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class ObjTest : public IoTest {
 protected:
  std::string error_of(const std::string& content) {
    return input_error([&] { read_obj(write("bad.obj", content)); });
  }
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

TEST_F(ObjTest, RoundTripKeepsEveryBitOfPositionsAndTheFilms) {
  SurfaceData data = two_tetrahedra();
  std::swap(data.triangles[1], data.triangles[5]);  // labels alternate
  std::swap(data.labels[1], data.labels[5]);
  write_obj(path("a.obj"), data);
  expect_same_surface(read_obj(path("a.obj")), film_by_film(data));
}

TEST_F(ObjTest, AFilmIsAGroupHoweverItsTrianglesAreWound) {
  SurfaceData data = two_tetrahedra();
  for (const std::size_t t : {0U, 2U, 3U, 5U}) {
    std::swap(data.triangles[t][0], data.triangles[t][1]);
    data.labels[t] = data.labels[t].flipped();
  }
  write_obj(path("a.obj"), data);
  std::istringstream lines(content_of(path("a.obj")));
  std::vector<std::string> groups;
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with("g ")) groups.push_back(line);
  EXPECT_EQ(groups, (std::vector<std::string>{"g region_1_0 film_0", "g region_2_0 film_1", "g region_2_1 film_2"}));
}

TEST_F(ObjTest, EmptySurfaceRoundTrip) {
  write_obj(path("a.obj"), {});
  EXPECT_EQ(read_obj(path("a.obj")), SurfaceData{});
}

TEST_F(ObjTest, LabelsAreGroups) {
  SurfaceData data;
  data.positions = {{0, 0, 0}, {1, 0, 0}, {0, 0.5, 0}};
  data.triangles = {{0, 1, 2}, {0, 2, 1}, {1, 2, 0}};
  data.labels = {{Region{1}, air}, {Region{1}, air}, {Region{12}, Region{3}}};
  write_obj(path("a.obj"), data);
  expect_contains(content_of(path("a.obj")),
                  "v 0 0 0\nv 1 0 0\nv 0 0.5 0\ng region_1_0 film_0\nf 1 2 3\ng region_1_0 film_1\nf 1 3 2\n"
                  "g region_12_3 film_2\nf 2 3 1\n");
}

// Of a ball the normals are the directions from its middle, whichever way its triangles run.
TEST_F(ObjTest, NormalsPointOutOfTheHigherRegion) {
  SurfaceData data = from_mesh(icosphere(2));
  for (std::size_t t = 0; t < data.triangles.size(); t += 2) {
    std::swap(data.triangles[t][0], data.triangles[t][1]);
    data.labels[t] = data.labels[t].flipped();
  }
  write_obj(path("ball.obj"), data, ObjNormals::with);
  EXPECT_EQ(read_obj(path("ball.obj")), film_by_film(data));
  std::istringstream lines(content_of(path("ball.obj")));
  std::size_t count = 0;
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("vn ")) continue;
    std::istringstream numbers(line.substr(3));
    Vec3 normal;
    numbers >> normal.x() >> normal.y() >> normal.z();
    EXPECT_NEAR(normal.norm(), 1, 1e-14);
    EXPECT_NEAR(normal.dot(data.positions[count].normalized()), 1, 5e-3);
    ++count;
  }
  EXPECT_EQ(count, data.positions.size());
}

TEST_F(ObjTest, ReadsAllFormsOfCorners) {
  const SurfaceData data = read_obj(write("a.obj", "# made by hand\nmtllib x.mtl\no thing\n" + square +
                                                       "vt 0 0\nvn 0 0 1\ns off\nusemtl red\nf 1 2 3\nf 1/1 2/1 3/1\n"
                                                       "f 1//1 2//1 3//1\nf 1/1/1 2/1/1 4/1/1\nf -4 -3 -1 # last\n"
                                                       "v 9 9 9 0.5 0.5 0.5\r\nf -1 +1 2\r\n\n  \n"));
  ASSERT_EQ(data.triangles.size(), 6U);
  for (const std::size_t t : {0U, 1U, 2U}) EXPECT_EQ(data.triangles[t], (std::array<std::uint32_t, 3>{0, 1, 2}));
  for (const std::size_t t : {3U, 4U}) EXPECT_EQ(data.triangles[t], (std::array<std::uint32_t, 3>{0, 1, 3}));
  EXPECT_EQ(data.triangles[5], (std::array<std::uint32_t, 3>{4, 0, 1}));
  EXPECT_EQ(data.positions[4], Vec3(9, 9, 9));
  EXPECT_EQ(data.labels, std::vector<Labels>(6, default_labels));
}

TEST_F(ObjTest, OtherGroupsMeanTheDefaultLabels) {
  const SurfaceData data = read_obj(
      write("a.obj",
            square + "g left region_2_7 top\nf 1 2 3\ng region_north\nf 1 2 3\ng\nf 1 2 3\ng region_0_3\nf 1 2 3\n"));
  const std::vector<Labels> expected{{Region{2}, Region{7}}, default_labels, default_labels, {air, Region{3}}};
  EXPECT_EQ(data.labels, expected);
}

TEST_F(ObjTest, FacesMayNameLaterVertices) {
  EXPECT_EQ(read_obj(write("a.obj", "f 1 2 3\n" + square)).triangles.size(), 1U);
  expect_contains(error_of("# x\nf 1 2 5\nf 1 2 3\n" + square),
                  "line 2: the face names vertex 5, but the file has only 4");
}

TEST_F(ObjTest, EveryVertexHasAVelocityOrNone) {
  const std::string first = "v 0 0 0\n#velocity 1 2 3\n", rest = "v 1 0 0\nv 0 1 0\nf 1 2 3\n";
  expect_contains(input_error([&] { read_obj(write("a.obj", first + rest)); }),
                  "some vertices have a line '#velocity'");
  expect_contains(input_error([&] { read_obj(write("a.obj", "#velocity 1 2 3\n" + first + rest)); }),
                  "line 1: this line has no vertex");
  expect_contains(input_error([&] { read_obj(write("a.obj", "v 0 0 0\n#vertex_id x\n" + rest)); }), "line 2: 'x'");
  EXPECT_TRUE(read_obj(write("a.obj", "v 0 0 0\n# velocity 1 2 3\n" + rest)).vertex_arrays.empty());
}

TEST_F(ObjTest, ErrorsNameTheLine) {
  expect_contains(error_of(""), "empty");
  expect_contains(error_of("solid cube\nfacet\n"), "line 1: 'solid' is no statement");
  expect_contains(error_of(square + "f 1 2\n"), "line 5: the face has 2 corners");
  expect_contains(error_of(square + "f 1 2 3 4\n"), "line 5: the face has 4 corners, not 3; triangulate");
  expect_contains(error_of(square + "f 1 2 0\n"), "line 5: '0' stands where a corner should");
  expect_contains(error_of(square + "f 1 2 -5\n"), "line 5: '-5'");
  expect_contains(error_of(square + "f 1 2 x\n"), "line 5: 'x'");
  expect_contains(error_of(square + "f 1 2 2\n"), "line 5: the triangle names vertex 2 twice");
  expect_contains(error_of(square + "f 1 2 99999999999\n"), "line 5");
  expect_contains(error_of("v 0 0\n"), "line 1: ''");
  expect_contains(error_of("v 0 0 1e999\n"), "line 1: '1e999'");
  expect_contains(error_of("v 0 0 inf\n"), "line 1: the position is (0, 0, inf)");
  expect_contains(error_of("v 0 0 0x10\n"), "line 1: '0x10'");
  expect_contains(error_of(square + "g region_1_1\n"), "line 5: the triangle's labels are (1, 1)");
  expect_contains(error_of(square + "g region_-1_0\n"), "line 5: the triangle's labels are (-1, 0)");
  expect_contains(error_of(square + "g region_1\n"), "region_1_0' would be right");
  expect_contains(error_of(square + "g region_1_x\n"), "line 5");
  expect_contains(error_of(square + std::string("\0", 1)), "zero byte");
}

}  // namespace
}  // namespace lostopos
