#include "LosTopos/io/ply.h"

#include <limits>

#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class PlyTest : public IoTest {
 protected:
  std::string error_of(const std::string& content) {
    return input_error([&] { read_ply(write("bad.ply", content)); });
  }
};

const std::string ascii_triangle =
    "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
    "element face 1\nproperty list uchar int vertex_indices\nproperty int region_a\nproperty int region_b\n"
    "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 4 0\n";

TEST_F(PlyTest, RoundTripKeepsEveryBit) {
  write_ply(path("a.ply"), two_tetrahedra());
  expect_same_surface(read_ply(path("a.ply")), two_tetrahedra());
}

TEST_F(PlyTest, EmptySurfaceRoundTrip) {
  write_ply(path("a.ply"), {});
  EXPECT_EQ(read_ply(path("a.ply")), SurfaceData{});
}

// What a picture leaves out.
TEST_F(PlyTest, SolidTrianglesAreKeptAndWrittenOnlyWhereThereAreAny) {
  SurfaceData data = two_tetrahedra();
  data.triangle_arrays = {{"solid", 1, std::vector<double>(data.triangles.size(), 0)}, {"other", 1, {}}};
  data.triangle_arrays[1].values = data.triangle_arrays[0].values;
  write_ply(path("a.ply"), data);
  EXPECT_TRUE(read_ply(path("a.ply")).triangle_arrays.empty());
  data.triangle_arrays[0].values[2] = 1;
  write_ply(path("a.ply"), data);
  const SurfaceData again = read_ply(path("a.ply"));
  expect_same_surface(again, data);
  ASSERT_EQ(again.triangle_arrays.size(), 1U);
  EXPECT_EQ(again.triangle_arrays[0], data.triangle_arrays[0]);
}

TEST_F(PlyTest, FrameLayoutIsTheDocumentedOne) {
  SurfaceData data;
  data.positions = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9.5}};
  data.triangles = {{2, 0, 1}};
  data.labels = {{Region{5}, air}};
  write_ply(path("a.ply"), data);
  const std::string content = content_of(path("a.ply"));
  const std::size_t body = content.find("end_header\n") + 11;
  expect_contains(content, "format binary_little_endian 1.0\n");
  expect_contains(content,
                  "element vertex 3\nproperty double x\nproperty double y\nproperty double z\n"
                  "element face 1\nproperty list uchar int vertex_indices\nproperty int region_a\n"
                  "property int region_b\nend_header\n");
  Bytes expected;
  for (const double x : {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.5}) expected.put(x);
  expected.put(std::uint8_t{3});
  for (const std::int32_t i : {2, 0, 1, 5, 0}) expected.put(i);
  EXPECT_EQ(content.substr(body), expected.str());
}

TEST_F(PlyTest, ReadsAscii) {
  const SurfaceData data = read_ply(write("a.ply", ascii_triangle));
  ASSERT_EQ(data.positions.size(), 3U);
  EXPECT_EQ(data.positions[1], Vec3(1, 0, 0));
  EXPECT_EQ(data.labels, (std::vector<Labels>{{Region{4}, air}}));
}

TEST_F(PlyTest, ReadsAsciiWithWindowsLineEnds) {
  std::string text;
  for (const char c : ascii_triangle) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
  EXPECT_EQ(read_ply(write("a.ply", text)), read_ply(write("b.ply", ascii_triangle)));
}

TEST_F(PlyTest, MissingRegionsAreOneBubbleInAir) {
  const std::string text =
      replaced(replaced(ascii_triangle, "property int region_a\nproperty int region_b\n", ""), "2 4 0", "2");
  EXPECT_EQ(read_ply(write("a.ply", text)).labels, (std::vector<Labels>{{Region{1}, Region{0}}}));
}

// Other properties before, between and after, lists too, other elements before and after, all types, other list name.
TEST_F(PlyTest, PassesOverWhatItDoesNotKnow) {
  for (const std::endian order : {std::endian::little, std::endian::big}) {
    const std::string name = order == std::endian::little ? "little" : "big";
    std::string body;
    const auto put = [&](auto value) {
      std::string raw;
      append_bytes(raw, value);
      if (order == std::endian::big) std::ranges::reverse(raw);
      body += raw;
    };
    put(std::uint8_t{9}), put(0.0), put(std::uint16_t{2}), put(1.0F), put(2.0F);  // element camera
    for (const float x : {0.0F, 1.5F, -2.0F}) {
      put(std::int8_t{-1}), put(x), put(std::uint32_t{2}), put(std::int16_t{7}), put(std::int16_t{8});
      put(std::int16_t{12}), put(x * x), put(std::uint8_t{255});
    }
    put(std::int8_t{3}), put(std::uint8_t{1}), put(std::uint32_t{2}), put(std::uint32_t{1}), put(std::uint32_t{0});
    put(std::int32_t{0}), put(0.25F), put(std::int16_t{6});
    put(std::int32_t{1}), put(std::int32_t{2});  // element edge
    const std::string header =
        "ply\nformat binary_" + name +
        "_endian 1.0\ncomment made by hand\nobj_info nothing\n"
        "element camera 1\nproperty uint8 a\nproperty float64 b\nproperty list ushort float c\n"
        "element vertex 3\nproperty char flag\nproperty float32 x\nproperty list uint int16 l\nproperty short y\n"
        "property float z\nproperty uchar red\n"
        "element face 1\nproperty int8 region_b\nproperty list uchar uint vertex_index\n"
        "property list int double none\nproperty float quality\nproperty int16 region_a\n"
        "element edge 1\nproperty int v1\nproperty int v2\nelement nothing 1152921504606846976\nend_header\n";
    // The list of the face has one entry here: no triangle.
    expect_contains(error_of(header + body), "corners");
    body.replace(body.find(std::string(1, '\x03') + '\x01'), 2, std::string(1, '\x05') + '\x03');
    const SurfaceData data = read_ply(write("a.ply", header + body));
    ASSERT_EQ(data.positions.size(), 3U) << name;
    EXPECT_EQ(data.positions[2], Vec3(-2.0, 12.0, 4.0));
    EXPECT_EQ(data.triangles[0], (std::array<std::uint32_t, 3>{2, 1, 0}));
    EXPECT_EQ(data.labels[0], (Labels{Region{6}, Region{5}}));
  }
}

TEST_F(PlyTest, FacesMayComeBeforeVertices) {
  const std::string text =
      "ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\n"
      "element vertex 3\nproperty double x\nproperty double y\nproperty double z\nend_header\n3 0 1 2\n"
      "0 0 0 1 0 0 0 1 0\n";
  EXPECT_EQ(read_ply(write("a.ply", text)).triangles.size(), 1U);
}

TEST_F(PlyTest, HeaderErrorsNameTheLine) {
  expect_contains(error_of(""), "line 1: not a PLY file");
  expect_contains(error_of("solid cube\n"), "line 1: not a PLY file");
  expect_contains(error_of(replaced(ascii_triangle, "ascii 1.0", "text 1.0")), "line 2: format 'text'");
  expect_contains(error_of(replaced(ascii_triangle, "ascii 1.0", "ascii 2.0")), "line 2: version '2.0'");
  expect_contains(error_of(replaced(ascii_triangle, "float y", "half y")), "line 5: type 'half'");
  expect_contains(error_of(replaced(ascii_triangle, "vertex 3", "vertex -3")), "line 3:");
  expect_contains(error_of(replaced(ascii_triangle, "vertex 3", "vertex 99999999999999999999")), "line 3:");
  expect_contains(error_of(replaced(ascii_triangle, "float y", "float x")), "line 5: property 'x' is declared twice");
  expect_contains(error_of(replaced(ascii_triangle, "element face", "element vertex")), "declared twice");
  expect_contains(error_of(replaced(ascii_triangle, "end_header", "end")), "'end' is no word of a PLY header");
  expect_contains(error_of("ply\nformat ascii 1.0\n"), "end_header");
  expect_contains(error_of("ply\nproperty int x\n"), "line 2: a property stands before");
  expect_contains(error_of("ply\nend_header\n"), "format");
}

TEST_F(PlyTest, ContentErrorsNameTheLineAndWhatWouldBeRight) {
  const auto wrong = [&](const char* from, const char* to) { return error_of(replaced(ascii_triangle, from, to)); };
  expect_contains(wrong("1 0 0\n", "1 nan 0\n"), "line 13: vertex 1: the position is (1, nan, 0)");
  expect_contains(wrong("1 0 0\n", "1 -inf 0\n"), "finite");
  expect_contains(wrong("1 0 0\n", "1 x 0\n"), "line 13: 'x' stands where");
  expect_contains(wrong("0 1 2 4 0", "0 1 3 4 0"), "line 15: face 0: the triangle names vertex 3");
  expect_contains(wrong("0 1 2 4 0", "0 1 -1 4 0"), "names vertex -1");
  expect_contains(wrong("0 1 2 4 0", "0 1 1 4 0"), "names vertex 1 twice");
  expect_contains(wrong("0 1 2 4 0", "0 1 2 4 4"), "labels are (4, 4)");
  expect_contains(wrong("0 1 2 4 0", "0 1 2 4 -1"), "labels are (4, -1)");
  expect_contains(wrong("0 1 2 4 0", "0 1 2 4 2147483648"), "labels are (4, 2147483648)");
  expect_contains(wrong("0 1 2 4 0", "0 1 2 4 0.5"), "whole number");
  expect_contains(wrong("3 0 1 2 4 0", "4 0 1 2 0 4 0"), "4 corners; triangulate");
  expect_contains(wrong("3 0 1 2 4 0", "3 0 1 2 4 0 9"), "'9' follows the last element");
  expect_contains(wrong("property int region_b\n", ""), "'region_a' without 'region_b'");
  expect_contains(wrong("float z", "float w"), "no property 'z'");
  expect_contains(wrong("vertex_indices", "corners"), "no list 'vertex_indices'");
  expect_contains(wrong("element face 1", "element faces 1"), "no element 'face'");
}

TEST_F(PlyTest, AbsurdCountsAreRefusedBeforeAnythingIsReserved) {
  for (const char* count : {"4", "2000000000", "1152921504606846976", "9223372036854775807"}) {
    error_of(replaced(ascii_triangle, "vertex 3", std::string("vertex ") + count));
    error_of(replaced(ascii_triangle, "face 1", std::string("face ") + count));
    const std::string binary = replaced(ascii_triangle, "ascii", "binary_little_endian");
    expect_contains(error_of(replaced(binary, "vertex 3", std::string("vertex ") + count)), ", byte ");
  }
}

TEST_F(PlyTest, BinaryErrorsNameTheByteOfTheRecord) {
  SurfaceData data = two_tetrahedra();
  write_ply(path("a.ply"), data);
  std::string content = content_of(path("a.ply"));
  const std::size_t body = content.find("end_header\n") + 11;
  const std::size_t second_face = body + 6 * 24 + 21;
  content[second_face] = 4;
  expect_contains(error_of(content), "byte " + std::to_string(second_face) + ": face 1 has 4 corners");
}

TEST_F(PlyTest, InvalidDataIsNotWritten) {
  SurfaceData data = two_tetrahedra();
  data.positions[3].x() = std::numeric_limits<double>::quiet_NaN();
  expect_contains(input_error([&] { write_ply(path("a.ply"), data); }), "vertex 3");
  EXPECT_EQ(files_in_folder(), 0U);
}

// Compared each with each, they would take minutes.
TEST_F(PlyTest, HundredsOfThousandsOfElementsAndPropertiesAreRead) {
  std::string header = "ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nproperty int y\nproperty int z\n";
  for (int i = 0; i < 200'000; ++i) header += "property int p" + std::to_string(i) + "\n";
  header += "element face 0\nproperty list uchar int vertex_indices\n";
  for (int i = 0; i < 200'000; ++i) header += "element e" + std::to_string(i) + " 0\n";
  EXPECT_TRUE(read_ply(write("many.ply", header + "end_header\n")).positions.empty());
  const std::string again = header + "element e199999 0\nend_header\n";
  expect_contains(input_error([&] { read_ply(write("many.ply", again)); }), "'e199999' is declared twice");
}

}  // namespace
}  // namespace lostopos
