#include <cstdlib>

#include "LosTopos/io/vtk_surface.h"
#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class VtuTest : public IoTest {
 protected:
  std::string error_of(const std::string& content) {
    return input_error([&] { read_vtu(write("bad.vtu", content)); });
  }
};

// A line and a triangle.
const std::string handmade_grid = R"(<?xml version="1.0"?>
<VTKFile type="UnstructuredGrid" version="0.1" byte_order="LittleEndian">
  <UnstructuredGrid>
    <Piece NumberOfPoints="3" NumberOfCells="2">
      <Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
      <Cells>
        <DataArray type="Int32" Name="connectivity" format="ascii">2 0 0 1 2</DataArray>
        <DataArray type="Int32" Name="offsets" format="ascii">2 5</DataArray>
        <DataArray type="UInt8" Name="types" format="ascii">3 5</DataArray>
      </Cells>
      <CellData>
        <DataArray type="Int32" Name="region_a" format="ascii">-1 7</DataArray>
        <DataArray type="Int32" Name="region_b" format="ascii">-1 2</DataArray>
      </CellData>
    </Piece>
  </UnstructuredGrid>
</VTKFile>
)";

SurfaceData with_lines_and_arrays() {
  SurfaceData data = two_tetrahedra();
  data.lines = {{0, 1}, {1, 2}};
  data.vertex_arrays = {{"velocity", 3, std::vector<double>(18, 1.0 / 3.0), "L/T"}};
  data.triangle_arrays = {{"area", 1, {1, 2, 3, 4, 5, 6, 7}}};
  return data;
}

TEST_F(VtuTest, RoundTripKeepsEveryBit) {
  write_vtu(path("a.vtu"), with_lines_and_arrays());
  EXPECT_EQ(read_vtu(path("a.vtu")), with_lines_and_arrays());
  write_vtu(path("b.vtu"), {});
  EXPECT_EQ(read_vtu(path("b.vtu")), SurfaceData{});
}

TEST_F(VtuTest, ReadsLinesAndTrianglesOfOthers) {
  const SurfaceData data = read_vtu(write("a.vtu", handmade_grid));
  EXPECT_EQ(data.lines, (std::vector<std::array<std::uint32_t, 2>>{{2, 0}}));
  EXPECT_EQ(data.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_EQ(data.labels, (std::vector<Labels>{{Region{7}, Region{2}}}));
}

TEST_F(VtuTest, SaysWhatItDoesNotRead) {
  expect_contains(error_of(replaced(handmade_grid, ">3 5<", ">5 3<")),
                  "cell 1 is of type 3; lines (3), and triangles (5) behind them, are read");
  expect_contains(error_of(replaced(handmade_grid, ">3 5<", ">3 9<")), "cell 1 is of type 9");
  expect_contains(error_of(replaced(handmade_grid, ">3 5<", ">3 nan<")), "cell 1 is of type nan");
  expect_contains(error_of(replaced(handmade_grid, ">3 5<", ">5<")), "array 'types': 1 numbers for 2 cells");
  expect_contains(error_of(replaced(handmade_grid, "2 0 0 1 2<", "2 0 0 1<")), "array 'connectivity': its length");
  expect_contains(error_of(replaced(handmade_grid, ">2 5<", ">2 6<")), "polygon 0 is no triangle");
  expect_contains(error_of(replaced(handmade_grid, "2 0 0 1 2<", "2 0 0 1 3<")), "3");
  expect_contains(error_of(replaced(handmade_grid, "\"types\"", "\"kinds\"")), "needs the array 'types'");
  expect_contains(input_error([&] { read_vtp(write("a.vtp", handmade_grid)); }), "UnstructuredGrid");
}

// An independent reader.
TEST_F(VtuTest, MeshioReadsIt) {
  if (std::system("/usr/bin/python3 -c 'import meshio' >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "python3-meshio is not installed";
  write_vtu(path("a.vtu"), with_lines_and_arrays());
  const std::string script =
      "import meshio\n"
      "mesh = meshio.read('" +
      path("a.vtu").string() +
      "')\n"
      "assert mesh.points.shape == (6, 3)\n"
      "assert [(c.type, len(c.data)) for c in mesh.cells] == [('line', 2), ('triangle', 7)], mesh.cells\n"
      "assert abs(mesh.point_data['velocity'] - 1 / 3).max() == 0\n"
      "assert list(mesh.cell_data['area'][1]) == [1, 2, 3, 4, 5, 6, 7]\n"
      "assert (mesh.cell_data['region_a'][1] >= 0).all()\n";
  const std::string command =
      "/usr/bin/python3 " + write("check.py", script).string() + " >" + path("log").string() + " 2>&1";
  EXPECT_EQ(std::system(command.c_str()), 0) << content_of(path("log"));
}

}  // namespace
}  // namespace lostopos
