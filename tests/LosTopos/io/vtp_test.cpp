#include <limits>

#include "LosTopos/io/base64.h"
#include "LosTopos/io/vtk_surface.h"
#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class VtpTest : public IoTest {
 protected:
  std::string error_of(const std::string& content) {
    return input_error([&] { read_vtp(write("bad.vtp", content)); });
  }
};

const std::string handmade_triangle = R"(<?xml version="1.0"?>
<VTKFile type="PolyData" version="0.1" byte_order="LittleEndian">
  <!-- by hand: <Piece> -->
  <PolyData>
    <Piece NumberOfPoints='3' NumberOfVerts="0" NumberOfPolys="1">
      <Points><DataArray type="Float32" NumberOfComponents="3" format="ascii">0 0 0 1 0 0 0 1 0</DataArray></Points>
      <Verts/>
      <Polys>
        <DataArray type="Int32" Name="connectivity" format="ascii">0 1 2</DataArray>
        <DataArray type="Int32" Name="offsets" format="ascii">3</DataArray>
      </Polys>
      <CellData>
        <DataArray type="Int32" Name="region_a" format="ascii">7</DataArray>
        <DataArray type="Int32" Name="region_b" format="ascii">2</DataArray>
      </CellData>
    </Piece>
  </PolyData>
</VTKFile>
)";

SurfaceData with_arrays() {
  SurfaceData data = two_tetrahedra();
  data.vertex_arrays = {{"speed & <\"height\">", 1, {0, 1, -2.5, 1e-300, 4, std::numeric_limits<double>::infinity()}},
                        {"velocity", 3, std::vector<double>(18, 1.0 / 3.0)}};
  data.triangle_arrays = {{"area", 1, {1, 2, 3, 4, 5, 6, 7}}, {"sheet strength", 2, std::vector<double>(14, -0.1)}};
  return data;
}

TEST_F(VtpTest, RoundTripKeepsEveryBitAndTheArrays) {
  write_vtp(path("a.vtp"), with_arrays());
  const SurfaceData data = read_vtp(path("a.vtp"));
  expect_same_surface(data, with_arrays());
  EXPECT_EQ(data.vertex_arrays, with_arrays().vertex_arrays);
  EXPECT_EQ(data.triangle_arrays, with_arrays().triangle_arrays);
}

TEST_F(VtpTest, EveryNamedAttributeThatIsANumberIsWritten) {
  SurfaceMesh mesh = to_mesh(two_tetrahedra());
  auto thickness = mesh.add_vertex_attribute<double>("thickness", carry::conserve);
  auto velocity = mesh.add_vertex_attribute<Vec3>("velocity", carry::interpolate, Vec3::Zero());
  auto layer = mesh.add_triangle_attribute<int>("layer", carry::copy);
  const auto work = mesh.add_vertex_attribute<double>(1);
  for (Vertex v : mesh.vertices()) {
    thickness[v] = 1.0 / (3 + v.index());
    velocity[v] = Vec3(1, 2, v.index());
  }
  mesh.remove_triangle(Triangle(1));
  for (Triangle t : mesh.triangles()) layer[t] = static_cast<int>(t.index()) + 5;
  write_vtp(path("a.vtp"), from_mesh_with_attributes(mesh));
  const SurfaceData read = read_vtp(path("a.vtp"));
  ASSERT_EQ(read.vertex_arrays.size(), 2U);
  EXPECT_EQ(read.vertex_arrays[0].name, "thickness");
  EXPECT_TRUE(std::ranges::equal(read.vertex_arrays[0].values, thickness.slots()));
  EXPECT_EQ(read.vertex_arrays[1].name, "velocity");
  EXPECT_EQ(read.vertex_arrays[1].components, 3);
  EXPECT_EQ(read.vertex_arrays[1].values[5], 1);
  ASSERT_EQ(read.triangle_arrays.size(), 1U);
  EXPECT_EQ(read.triangle_arrays[0].name, "layer");
  EXPECT_EQ(read.triangle_arrays[0].values.size(), mesh.triangle_count());
  EXPECT_EQ(read.triangle_arrays[0].values[1], 7) << "the living ones in order";
  EXPECT_TRUE(from_mesh(mesh).vertex_arrays.empty());
}

TEST_F(VtpTest, LinesAndUnitsStayAndLinesHaveNoValues) {
  SurfaceData data = with_arrays();
  data.lines = {{0, 1}, {1, 2}};
  data.triangle_arrays[0].unit = "L^2/T";
  write_vtp(path("a.vtp"), data);
  EXPECT_EQ(read_vtp(path("a.vtp")), data);
  data.lines.push_back({0, 6});
  expect_contains(input_error([&] { write_vtp(path("b.vtp"), data); }), "line 2: vertex 6 does not exist");
}

// An array of a thousand times its bytes, and blocks that are cut or say what they do not hold.
TEST_F(VtpTest, CompressedArraysAreReadAndDamagedOnesRefused) {
  SurfaceData data = with_arrays();
  data.vertex_arrays = {{"zero", 1000, std::vector<double>(6000, 0)}, {"one", 1000, std::vector<double>(6000, 1)}};
  write_vtp(path("a.vtp"), data);
  EXPECT_EQ(read_vtp(path("a.vtp")), data);
  const std::string text = content_of(path("a.vtp"));
  EXPECT_LT(text.size(), 8000U) << "of 96,000 bytes";
  const std::size_t begin = text.find("binary\">\n") + 9;
  for (std::size_t i = begin; i < begin + 44; ++i) {
    std::string damaged = text;
    damaged[i] = damaged[i] == 'f' ? 'g' : 'f';
    try {
      read_vtp(write("bad.vtp", damaged));  // what zlib passes over may be read
    } catch (const base::InputError& error) {
      expect_contains(error.what(), "array 'zero'");
    }
  }
}

TEST_F(VtpTest, EmptySurfaceRoundTrip) {
  write_vtp(path("a.vtp"), {});
  EXPECT_EQ(read_vtp(path("a.vtp")), SurfaceData{});
}

TEST_F(VtpTest, ReadsAscii) {
  const SurfaceData data = read_vtp(write("a.vtp", handmade_triangle));
  EXPECT_EQ(data.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(data.labels, (std::vector<Labels>{{Region{7}, Region{2}}}));
  EXPECT_TRUE(data.triangle_arrays.empty());
}

TEST_F(VtpTest, MissingRegionsAreOneBubbleInAir) {
  std::string text = handmade_triangle;
  const std::size_t cells = text.find("<CellData>"), end = text.find("</CellData>");
  text.erase(cells, end + 11 - cells);
  EXPECT_EQ(read_vtp(write("a.vtp", text)).labels, (std::vector<Labels>{default_labels}));
}

// The byte count as UInt32 of the big end, encoded apart from the numbers as some programs do.
TEST_F(VtpTest, ReadsOtherEncodingsOfBinary) {
  const std::string count("\0\0\0\x0c", 4), ids("\0\0\0\x02\0\0\0\x00\0\0\0\x01", 12);
  std::string text = replaced(handmade_triangle, "LittleEndian", "BigEndian");
  text =
      replaced(text, "Name=\"connectivity\" format=\"ascii\">0 1 2",
               "Name=\"connectivity\" format=\"binary\">\n " + base64_encode(count) + "\n" + base64_encode(ids) + "\n");
  EXPECT_EQ(read_vtp(write("a.vtp", text)).triangles[0], (std::array<std::uint32_t, 3>{2, 0, 1}));
}

TEST_F(VtpTest, ErrorsNameLineAndArray) {
  const auto wrong = [&](const char* from, const std::string& to) {
    return error_of(replaced(handmade_triangle, from, to));
  };
  expect_contains(error_of(""), "no XML element");
  expect_contains(error_of("ply\n"), "line 1: text stands outside");
  expect_contains(wrong("PolyData\" v", "UnstructuredGrid\" v"), "line 2: a VTK file of type 'UnstructuredGrid'");
  expect_contains(wrong("version=\"0.1\"", "compressor=\"vtkLZ4DataCompressor\""), "save the file with zlib");
  expect_contains(wrong("0 1 2<", "0 1 3<"), "line 9: array 'connectivity': polygon 0: the triangle names vertex 3");
  expect_contains(wrong("0 1 2<", "0 1 1<"), "names vertex 1 twice");
  expect_contains(wrong("0 1 2<", "0 1 1.5<"), "should be whole");
  expect_contains(wrong("0 1 2<", "0 1 nan<"), "should be whole");
  expect_contains(wrong("0 1 2<", "0 1 1e30<"), "should be whole");
  expect_contains(wrong("0 1 2<", "0 1<"), "2 numbers; 1 times 3 are wanted");
  expect_contains(wrong(">3<", ">4<"), "polygon 0 is no triangle");
  expect_contains(wrong(">7<", ">2<"), "labels are (2, 2)");
  expect_contains(wrong(">7<", ">-7<"), "labels are (-7, 2)");
  expect_contains(wrong("region_a", "region_x"), "region_a is missing");
  expect_contains(wrong("0 0 0 1", "0 inf 0 1"), "line 6: array '': point 0: the position is (0, inf, 0)");
  expect_contains(wrong("NumberOfVerts=\"0\"", "NumberOfVerts=\"1\""), "only lines and polygons");
  expect_contains(wrong("NumberOfPoints='3'", "NumberOfPoints='x'"), "line 5: NumberOfPoints is 'x'");
  expect_contains(wrong("NumberOfPoints='3'", "NumberOfPoints='1152921504606846976'"), "at most");
  expect_contains(wrong("NumberOfPoints='3'", "NumberOfPoints='2000000000'"), "2000000000 times 3");
  expect_contains(wrong("NumberOfPolys=\"1\"", "NumberOfPolys=\"1000000000\""), "1000000000 times 1");
  expect_contains(wrong("Int32", "Int33"), "'Int33' is no number type");
  expect_contains(wrong("format=\"ascii\"", "format=\"appended\""), "inline, not appended");
  expect_contains(wrong("format=\"ascii\"", "format=\"binary\""), "");
  expect_contains(wrong("</Points>", "</Point>"), "line 6: the end of 'Point' stands where that of 'Points' should");
  expect_contains(wrong("</VTKFile>", ""), "the file ends within the element 'VTKFile'");
  expect_contains(wrong("</VTKFile>", "</VTKFile><x/>"), "second root");
  expect_contains(wrong("<!-- by hand: <Piece> -->", "<!DOCTYPE x>"), "line 3: document types");
}

TEST_F(VtpTest, DeepNestingIsRefused) {
  std::string text = "<VTKFile type=\"PolyData\"><PolyData>";
  for (int i = 0; i < 100000; ++i) text += "<a>";
  expect_contains(error_of(text), "deep");
}

TEST_F(VtpTest, ArraysThatCannotBeWrittenAreRefused) {
  const auto error_with = [&](DataArray array) {
    SurfaceData data = two_tetrahedra();
    data.triangle_arrays = {std::move(array)};
    return input_error([&] { write_vtp(path("a.vtp"), data); });
  };
  const std::vector<double> values(7, 0.0);
  expect_contains(error_with({"region_a", 1, values}), "taken");
  expect_contains(error_with({"", 1, values}), "no name");
  expect_contains(error_with({"a\nb", 1, values}), "control character");
  expect_contains(error_with({"a", 2, values}), "2 for each of the 7 triangles");
  expect_contains(error_with({"a", 0, values}), "array 'a'");
  EXPECT_EQ(files_in_folder(), 0U);
}

// RFC 4648, section 10.
TEST(Base64, TestVectors) {
  const std::pair<const char*, const char*> vectors[] = {{"", ""},
                                                         {"f", "Zg=="},
                                                         {"fo", "Zm8="},
                                                         {"foo", "Zm9v"},
                                                         {"foob", "Zm9vYg=="},
                                                         {"fooba", "Zm9vYmE="},
                                                         {"foobar", "Zm9vYmFy"}};
  for (const auto& [bytes, text] : vectors) {
    EXPECT_EQ(base64_encode(bytes), text);
    EXPECT_EQ(base64_decode(text), bytes);
  }
  std::string all;
  for (int i = 0; i < 256; ++i) all += static_cast<char>(i);
  EXPECT_EQ(base64_decode(base64_encode(all)), all);
}

TEST(Base64, MalformedIsRefused) {
  for (const char* text : {"Z", "Zg", "Zg=", "Z===", "====", "Zg=a", "Z*==", "Zm9v!"})
    EXPECT_EQ(base64_decode(text), std::nullopt) << text;
  EXPECT_EQ(base64_decode(" Zm\n9v\t"), "foo");
}

// Compared each with each, or their lines counted from the first one on, they would take minutes.
TEST_F(VtpTest, HundredsOfThousandsOfArraysAreRead) {
  std::string text = "<VTKFile type=\"PolyData\"><PolyData><Piece NumberOfPoints=\"0\">\n<PointData>\n";
  for (int i = 0; i < 200'000; ++i) text += "<DataArray type=\"Int8\" Name=\"a" + std::to_string(i) + "\"/>\n";
  const std::string end = "</PointData></Piece></PolyData></VTKFile>";
  EXPECT_EQ(read_vtp(write("many.vtp", text + end)).vertex_arrays.size(), 200'000U);
  const std::string again = text + "<DataArray type=\"Int8\" Name=\"a7\"/>\n" + end;
  expect_contains(input_error([&] { read_vtp(write("many.vtp", again)); }),
                  "line 200003: array 'a7': the name is taken");
}

TEST_F(VtpTest, AnElementWithAThousandAttributesIsRefused) {
  std::string text = "<VTKFile";
  for (int i = 0; i < 1000; ++i) text += " a" + std::to_string(i) + "=''";
  expect_contains(input_error([&] { read_vtp(write("many.vtp", text + "/>")); }), "more than 100 attributes");
}

}  // namespace
}  // namespace lostopos
