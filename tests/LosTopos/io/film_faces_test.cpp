#include "LosTopos/io/film_faces.h"

#include "tests/LosTopos/io/io_test_tools.h"

namespace lostopos {
namespace {

TEST(FilmFaces, TheLowerRegionLiesBehindEveryTriangle) {
  SurfaceData data = two_tetrahedra();
  put_lower_regions_behind(data);
  EXPECT_EQ(data.labels[0], (Labels{air, Region{1}}));
  EXPECT_EQ(data.triangles[0], (std::array<std::uint32_t, 3>{0, 3, 1}));
  EXPECT_EQ(data.labels[3], (Labels{Region{1}, Region{2}}));
  EXPECT_EQ(data.triangles[3], two_tetrahedra().triangles[3]);
}

TEST(FilmFaces, AFilmEndsAtPlateauBorders) {
  EXPECT_EQ(film_numbers(two_tetrahedra()), (std::vector<std::uint32_t>{0, 0, 0, 2, 1, 1, 1}));
  EXPECT_EQ(border_edges(two_tetrahedra()), (std::vector<std::array<std::uint32_t, 2>>{{0, 1}, {0, 2}, {1, 2}}));
  SurfaceData apart = two_tetrahedra();
  apart.triangles = {{0, 1, 3}, {0, 1, 2}};
  apart.labels = {{Region{1}, air}, {air, Region{2}}};
  EXPECT_EQ(film_numbers(apart), (std::vector<std::uint32_t>{0, 1})) << "between other regions";
}

}  // namespace
}  // namespace lostopos
