#include "LosTopos/io/rec.h"

#include <limits>

#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class RecTest : public IoTest {
 protected:
  std::string error_of(const std::string& content) {
    return input_error([&] { read_rec(write("bad.rec", content)); });
  }
  std::string text_error_of(const std::string& content) {
    return input_error([&] { read_arec(write("bad.arec", content)); });
  }
};

constexpr double used = 0.5, unused = -99.0;

// Three vertices, regions 0 to 2, one triangle (1, 0): the circulation of pair (0, 1) is used; that of (0, 2) and (1,
// 2) is kept where it is not zero; what stands on and below the diagonal means nothing.
std::string soap_film_bytes(double special = 0.0) {
  Bytes bytes;
  bytes.put(std::uint64_t{3}).put(std::uint64_t{3});
  for (int v = 0; v < 3; ++v) {
    for (const double x : {0.0 + v, 1.0 * v * v, 2.0}) bytes.put(x);
    for (const double value : {unused, v == 1 ? 0.0 : used, special, unused, unused, v == 2 ? 4.0 : 0.0, unused, unused,
                               std::numeric_limits<double>::quiet_NaN()})
      bytes.put(value);
  }
  bytes.put(std::uint64_t{1});
  for (const std::uint64_t corner : {0U, 1U, 2U}) bytes.put(corner);
  bytes.put(std::int32_t{1}).put(std::int32_t{0});
  bytes.put(std::uint64_t{1}).put(std::uint64_t{2}).put(0.5).put(0.25).put(-1.0);
  return bytes.str();
}

std::string tracker_bytes() {
  Bytes bytes;
  bytes.put(std::uint64_t{3});
  for (int i = 0; i < 9; ++i) bytes.put(0.5 * i * i);
  bytes.put(std::uint64_t{2});
  for (const std::uint64_t corner : {0U, 1U, 2U}) bytes.put(corner);
  bytes.put(std::int32_t{1}).put(std::int32_t{0});
  for (const std::uint64_t corner : {2U, 1U, 0U}) bytes.put(corner);
  bytes.put(std::int32_t{5}).put(std::int32_t{2});
  return bytes.str();
}

TEST_F(RecTest, ReadsTheSoapFilmFlavourByHand) {
  const SurfaceData data = read_rec(write("a.rec", soap_film_bytes()));
  EXPECT_EQ(data.declared_regions, 3U);
  ASSERT_EQ(data.positions.size(), 3U);
  EXPECT_EQ(data.positions[2], Vec3(2, 4, 2));
  EXPECT_EQ(data.triangles, (std::vector<std::array<std::uint32_t, 3>>{{0, 1, 2}}));
  EXPECT_EQ(data.labels, (std::vector<Labels>{{Region{1}, air}}));
  const std::vector<PairValue> expected{
      {air, Region{1}, used}, {air, Region{1}, 0.0}, {air, Region{1}, used}, {Region{1}, Region{2}, 4.0}};
  EXPECT_EQ(data.pair_arrays.at(0).values, expected);
  EXPECT_EQ(data.pair_arrays.at(0).offsets, (std::vector<std::size_t>{0, 1, 2, 4}));
  ASSERT_EQ(data.held.size(), 1U);
  EXPECT_EQ(data.held[0], (HeldVertex{2, {0.5, 0.25, -1.0}}));
}

TEST_F(RecTest, ReadsTheTrackerFlavourByHand) {
  const SurfaceData data = read_rec(write("a.rec", tracker_bytes()));
  EXPECT_EQ(data.declared_regions, 0U);
  EXPECT_EQ(data.positions[2], Vec3(18.0, 24.5, 32.0));
  EXPECT_EQ(data.labels, (std::vector<Labels>{{Region{1}, air}, {Region{5}, Region{2}}}));
  EXPECT_TRUE(data.pair_arrays.empty());
  EXPECT_TRUE(data.held.empty());
}

TEST_F(RecTest, SoapFilmRoundTrip) {
  const SurfaceData data = two_tetrahedra_with_circulation();
  write_rec(path("a.rec"), data);
  EXPECT_EQ(read_rec(path("a.rec")), data);
  expect_same_surface(read_rec(path("a.rec")), data);
  EXPECT_EQ(std::filesystem::file_size(path("a.rec")), 8 + 8 + 6 * (24 + 8 * 16) + 8 + 7 * 32 + 8 + 2 * 32U);
}

TEST_F(RecTest, TrackerRoundTrip) {
  write_rec(path("a.rec"), two_tetrahedra_with_circulation(), RecFlavour::Tracker);
  EXPECT_EQ(read_rec(path("a.rec")), two_tetrahedra());
  expect_same_surface(read_rec(path("a.rec")), two_tetrahedra());
}

TEST_F(RecTest, WithoutCirculationZerosAreWrittenForThePairsThatMeet) {
  write_rec(path("a.rec"), two_tetrahedra());
  const SurfaceData data = read_rec(path("a.rec"));
  EXPECT_EQ(data.declared_regions, 3U);
  EXPECT_EQ(data.pair_arrays.at(0).at(0).size(), 3U);
  EXPECT_EQ(data.pair_arrays.at(0).at(3).size(), 1U);
  EXPECT_EQ(data.pair_arrays.at(0).at(5).size(), 0U);
}

TEST_F(RecTest, EmptySurfaceRoundTripOfBothFlavours) {
  for (const RecFlavour flavour : {RecFlavour::SoapFilm, RecFlavour::Tracker}) {
    write_rec(path("a.rec"), {}, flavour);
    const SurfaceData data = read_rec(path("a.rec"));
    EXPECT_TRUE(data.positions.empty() && data.triangles.empty() && data.held.empty());
    EXPECT_EQ(data.pair_arrays.empty(), flavour == RecFlavour::Tracker);
  }
}

// 300 regions at 4 vertices: 2.9 MB of zeros in the file, 16 values in memory.
TEST_F(RecTest, ManyRegionsAreReadSparsely) {
  SurfaceData data = two_tetrahedra();
  data.declared_regions = 300;
  data.labels[0] = {Region{299}, Region{150}};
  write_rec(path("a.rec"), data);
  const SurfaceData read = read_rec(path("a.rec"));
  expect_same_surface(read, data);
  EXPECT_LE(read.pair_arrays.at(0).values.size(), 16U);
  ASSERT_FALSE(read.pair_arrays.at(0).at(0).empty());
  EXPECT_EQ(read.pair_arrays.at(0).at(0).back(), (PairValue{Region{150}, Region{299}, 0.0}));
}

TEST_F(RecTest, TooLargeForTheFormatIsRefused) {
  SurfaceData data = two_tetrahedra();
  data.labels[0] = {Region{1000000}, air};
  expect_contains(input_error([&] { write_rec(path("a.rec"), data); }), "1000001 regions");
  EXPECT_EQ(files_in_folder(), 0U);
  EXPECT_NO_THROW(write_rec(path("a.rec"), data, RecFlavour::Tracker));
}

TEST_F(RecTest, ErrorsNameTheByte) {
  const std::size_t triangle = 16 + 3 * (24 + 72) + 8;
  const auto with = [](std::size_t place, auto value) {
    std::string content = soap_film_bytes(), raw;
    append_bytes(raw, value);
    return content.replace(place, raw.size(), raw);
  };
  const std::string at_triangle = "byte " + std::to_string(triangle) + ": triangle 0: ";
  expect_contains(error_of(with(triangle, std::uint64_t{3})), at_triangle + "the triangle names vertex 3");
  expect_contains(error_of(with(triangle, ~std::uint64_t{0})), at_triangle);
  expect_contains(error_of(with(triangle, std::uint64_t{1})), at_triangle + "the triangle names vertex 1 twice");
  expect_contains(error_of(with(triangle + 24, std::int32_t{0})), at_triangle + "the triangle's labels are (0, 0)");
  expect_contains(error_of(with(triangle + 24, std::int32_t{-1})), "labels are (-1, 0)");
  expect_contains(error_of(with(triangle + 24, std::int32_t{3})), "label 3, but the file declares regions 0 to 2");
  expect_contains(error_of(with(16, std::numeric_limits<double>::infinity())),
                  "byte 16: vertex 0: the position is (inf");
  expect_contains(error_of(with(triangle + 40, std::uint64_t{3})), "held vertex 0: it names vertex 3 of 3");
  expect_contains(error_of(with(triangle + 48, std::numeric_limits<double>::quiet_NaN())),
                  "held vertex 0: the position");
  expect_contains(error_of(soap_film_bytes(std::numeric_limits<double>::quiet_NaN())),
                  "byte 56: vertex 0: the circulation of regions 0 and 2 is not finite");
}

TEST_F(RecTest, WrongCountsFitNoFlavour) {
  expect_contains(error_of(""), "no flavour of .rec fits");
  expect_contains(error_of("not a mesh at all, but long enough for two counts"), "no flavour of .rec fits");
  for (const std::size_t place : {0U, 8U}) {
    for (const std::uint64_t count : {std::uint64_t{4}, std::uint64_t{1} << 28U, std::uint64_t{1} << 31U,
                                      std::uint64_t{1} << 60U, ~std::uint64_t{0}}) {
      std::string content = soap_film_bytes(), raw;
      append_bytes(raw, count);
      expect_contains(error_of(content.replace(place, 8, raw)), "no flavour of .rec fits");
    }
  }
  expect_contains(error_of(soap_film_bytes() + "x"), "1 bytes are left over");
  expect_contains(error_of(tracker_bytes() + "x"), "1 bytes are left over");
}

// 8 n² is 0 in 64 bits for these n, so that a careless product finds room for the vertices.
TEST_F(RecTest, RegionCountsWhoseSquareOverflows) {
  for (const std::uint64_t regions : {std::uint64_t{1} << 31U, std::uint64_t{1} << 32U, std::uint64_t{1} << 63U}) {
    for (const std::uint64_t vertices : {0U, 1U}) {
      Bytes bytes;
      bytes.put(regions).put(vertices);
      for (std::uint64_t i = 0; i < 3 * vertices; ++i) bytes.put(1.5);
      bytes.put(std::uint64_t{0}).put(std::uint64_t{0});
      expect_contains(error_of(bytes.str()), "byte 8: a count of " + std::to_string(regions) + " regions");
    }
  }
}

TEST_F(RecTest, ArecRoundTrip) {
  write_arec(path("a.arec"), two_tetrahedra_with_circulation());
  EXPECT_EQ(read_arec(path("a.arec")), two_tetrahedra());
  expect_same_surface(read_arec(path("a.arec")), two_tetrahedra());
  write_arec(path("a.arec"), {});
  EXPECT_EQ(read_arec(path("a.arec")), SurfaceData{});
}

TEST_F(RecTest, ReadsArecByHandWithAnySpacing) {
  const SurfaceData data = read_arec(write("a.arec", "3\n0 0 0\n1 0 0\n\n0 1e0 +0.5\n1\n0 1 2 4 0\n"));
  EXPECT_EQ(data.positions[2], Vec3(0, 1, 0.5));
  EXPECT_EQ(data.labels, (std::vector<Labels>{{Region{4}, air}}));
  EXPECT_EQ(data, read_arec(write("b.arec", "3 0 0 0 1 0 0 0 1 0.5 1\t0 1 2\r\n4 0")));
}

TEST_F(RecTest, ArecErrorsNameTheLine) {
  const std::string vertices = "3\n0 0 0\n1 0 0\n0 1 0\n";
  expect_contains(text_error_of(""), "line 1: the file ends where the number of vertices");
  expect_contains(text_error_of("solid cube"), "line 1: 'solid' stands where");
  expect_contains(text_error_of("-3\n"), "line 1: the number of vertices is -3");
  expect_contains(text_error_of("1152921504606846976\n0 0 0\n"), "line 1: 1152921504606846976 vertices");
  expect_contains(text_error_of("3\n0 0 0\n1.125 0 0\n0 1 "), "line 4: the file ends where a coordinate");
  expect_contains(text_error_of("3\n0 0 0\n1 nan 0\n0 1 0\n0\n"), "line 3: the position");
  expect_contains(text_error_of(vertices + "1\n0 1 3 1 0\n"), "line 6: the triangle names vertex 3");
  expect_contains(text_error_of(vertices + "1\n0 1 0 1 0\n"), "line 6: the triangle names vertex 0 twice");
  expect_contains(text_error_of(vertices + "1\n0 1 2 1 1\n"), "line 6: the triangle's labels are (1, 1)");
  expect_contains(text_error_of(vertices + "1\n0 1 2 -1 1\n"), "line 6: the triangle's labels are (-1, 1)");
  expect_contains(text_error_of(vertices + "1\n0 1 2.5 1 0\n"), "line 6: '2.5' stands where a vertex number");
  expect_contains(text_error_of(vertices + "1\n0 1 2 1 0\n7\n"), "line 7: '7' follows the last triangle");
  expect_contains(text_error_of(vertices + "400000000\n0 1 2 1 0\n"), "line 5: 400000000 triangles");
}

}  // namespace
}  // namespace lostopos
