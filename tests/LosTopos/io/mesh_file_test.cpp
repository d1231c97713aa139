#include "LosTopos/io/mesh_file.h"

#include "LosTopos/io/rec.h"
#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

class MeshFileTest : public IoTest {
 protected:
  static SurfaceData kept_by(const MeshFormat& format) {
    return format.extension == ".obj" ? film_by_film(two_tetrahedra()) : two_tetrahedra();
  }
  std::filesystem::path path_with(std::string_view extension) const { return path("a").replace_extension(extension); }
};

TEST_F(MeshFileTest, EveryFormatKeepsTheSurface) {
  for (const MeshFormat& format : mesh_formats()) {
    const auto file = path_with(format.extension);
    write_surface(file, two_tetrahedra_with_circulation());
    const SurfaceData data = read_surface(file);
    expect_same_surface(data, kept_by(format));
    EXPECT_EQ(!data.pair_arrays.empty(), format.keeps_pair_arrays) << format.extension;
    EXPECT_EQ(!data.held.empty(), format.keeps_held) << format.extension;
  }
}

TEST_F(MeshFileTest, ArraysAreKeptWhereTheFormatSaysSo) {
  SurfaceData with_array = two_tetrahedra();
  with_array.vertex_arrays = {{"a", 1, std::vector<double>(6, 1.5)}};
  for (const MeshFormat& format : mesh_formats()) {
    const auto file = path_with(format.extension);
    write_surface(file, with_array);
    EXPECT_EQ(!read_surface(file).vertex_arrays.empty(), format.keeps_arrays) << format.extension;
  }
}

TEST_F(MeshFileTest, ArraysThatAFormatKeepsByNameAreKept) {
  for (const MeshFormat& format : mesh_formats()) {
    SurfaceData with_arrays = two_tetrahedra();
    const std::size_t vertices = with_arrays.positions.size();
    for (const std::string_view name : format.kept_vertex_arrays) {
      const bool is_vector = name == velocity_array;
      DataArray array{std::string(name), is_vector ? 3 : 1, {}, is_vector ? "L/T" : ""};
      for (std::size_t i = 0; i < vertices * (is_vector ? 3 : 1); ++i)
        array.values.push_back(is_vector ? 0.1 * static_cast<double>(i) - 0.7 : static_cast<double>(7 * i));
      with_arrays.vertex_arrays.push_back(std::move(array));
    }
    for (const std::string_view name : format.kept_triangle_arrays)
      with_arrays.triangle_arrays.push_back({std::string(name), 1, {0, 1, 1, 0, 1, 0, 1}});
    const auto file = path_with(format.extension);
    write_surface(file, with_arrays);
    const SurfaceData again = read_surface(file);
    EXPECT_EQ(again.vertex_arrays, with_arrays.vertex_arrays) << format.extension;
    EXPECT_EQ(again.triangle_arrays, with_arrays.triangle_arrays) << format.extension;
  }
}

// Numbers of vertices that are none, and velocities that are no vectors, are left out, not cut down.
TEST_F(MeshFileTest, ArraysOfAnotherKindAreNotTakenForThese) {
  SurfaceData data = two_tetrahedra();
  const std::size_t vertices = data.positions.size();
  for (const double id : {0.5, 3e9, std::numeric_limits<double>::quiet_NaN()}) {
    data.vertex_arrays = {{vertex_id_array, 1, std::vector<double>(vertices, id)},
                          {velocity_array, 1, std::vector<double>(vertices, 1)}};
    for (const char* name : {"a.ply", "a.obj"}) {
      write_surface(path(name), data);
      EXPECT_TRUE(read_surface(path(name)).vertex_arrays.empty()) << name << " " << id;
    }
  }
}

TEST_F(MeshFileTest, ContentDecidesWhereTheExtensionDoesNot) {
  for (const MeshFormat& format : mesh_formats()) {
    const auto file = path_with(format.extension);
    write_surface(file, two_tetrahedra());
    std::filesystem::rename(file, path("frame"));
    expect_same_surface(read_surface(path("frame")), kept_by(format));
    EXPECT_EQ(sniff_mesh_format(path("frame")), find_mesh_format(file)) << format.extension;
  }
}

TEST_F(MeshFileTest, TrackerRecIsSniffedToo) {
  write_rec(path("a"), two_tetrahedra(), RecFlavour::Tracker);
  expect_same_surface(read_surface(path("a")), two_tetrahedra());
}

// 8,242 vertices: the first bytes of the count are "2 ", a number followed by a space.
TEST_F(MeshFileTest, RecThatStartsLikeTextIsStillARec) {
  SurfaceData data = two_tetrahedra();
  data.positions.resize(8242, Vec3::Zero());
  write_rec(path("a"), data, RecFlavour::Tracker);
  expect_same_surface(read_surface(path("a")), data);
}

TEST_F(MeshFileTest, ExtensionIsReadInSmallOrCapitalLetters) {
  write_surface(path("A.PLY"), two_tetrahedra());
  expect_same_surface(read_surface(path("A.PLY")), two_tetrahedra());
}

TEST_F(MeshFileTest, ContentThatContradictsTheExtension) {
  write_surface(path("a.ply"), two_tetrahedra());
  std::filesystem::rename(path("a.ply"), path("a.obj"));
  expect_contains(input_error([&] { read_surface(path("a.obj")); }), "has the content of a .ply file");
}

TEST_F(MeshFileTest, UnknownFormatsAreRefusedWithTheKnownOnes) {
  const std::string known = ".ply, .obj, .vtp, .vtu, .fe, .rec, .arec";
  expect_contains(input_error([&] { write_surface(path("a.stl"), two_tetrahedra()); }), known);
  expect_contains(input_error([&] { write_surface(path("a"), two_tetrahedra()); }), known);
  EXPECT_EQ(files_in_folder(), 0U);
  expect_contains(input_error([&] { read_surface(write("a.stl", "solid cube\n")); }), known);
  expect_contains(input_error([&] { read_surface(write("empty", "")); }), known);
}

TEST_F(MeshFileTest, WhatIsNoFile) {
  for (const std::string& extension : {std::string(".ply"), std::string(".obj"), std::string(".vtp"),
                                       std::string(".fe"), std::string(".rec"), std::string(".arec"), std::string()}) {
    const auto file = path("missing").replace_extension(extension);
    EXPECT_THROW(read_surface(file), base::FileError);
    expect_contains(input_error([&] { read_surface(file); }), file.string());
    const auto folder = path("folder").replace_extension(extension);
    std::filesystem::create_directory(folder);
    EXPECT_THROW(read_surface(folder), base::FileError);
    EXPECT_THROW(write_surface(folder, two_tetrahedra()), base::InputError);
  }
  expect_contains(input_error([&] { read_surface("/dev/zero"); }), "not a regular file");
}

}  // namespace
}  // namespace lostopos
