#include "FoamSim/sheet/pressure/vertex_area/vertex_area.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "Base/error.h"
#include "FoamSim/scenes/shapes/double_bubble.h"
#include "FoamSim/scenes/shapes/junction_frames.h"
#include "FoamSim/sheet/pressure/vertex_area/registry.h"
#include "tests/support/sample_meshes.h"

namespace foamsim {
namespace {

using lostopos::Edge;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vertex;

class VertexAreas : public testing::Test {
 protected:
  VertexAreas() { geometry.update(mesh); }

  std::vector<double> areas(std::string_view strategy, Vertex v, const VertexAreaOptions& options = {}) const {
    const VertexStar star{mesh, geometry, v, geometry.regions(v), mesh.is_junction(v)};
    std::vector<double> result(star.regions.size());
    make_vertex_area(strategy, options)->evaluate(star, result);
    return result;
  }

  SurfaceMesh mesh = double_bubble(16);
  SurfaceGeometry geometry;
};

TEST_F(VertexAreas, NaiveOnesAddUpToEachRegionsSurface) {
  std::array<double, 3> sum{}, surface{};
  for (Vertex v : mesh.vertices()) {
    const auto naive = areas("naive", v);
    for (std::size_t i = 0; i < naive.size(); ++i) sum[geometry.regions(v)[i].index()] += naive[i];
  }
  for (Triangle t : mesh.triangles())
    for (Region r : {mesh.labels(t).p, mesh.labels(t).q}) surface[r.index()] += geometry.area(t);
  for (std::size_t r = 0; r < 3; ++r) EXPECT_NEAR(sum[r] / surface[r], 1, 1e-13);
}

TEST_F(VertexAreas, AllStrategiesAgreeOffTheJunctions) {
  for (Vertex v : mesh.vertices()) {
    if (mesh.is_junction(v)) continue;
    const auto naive = areas("naive", v), constant = areas("constant-edge", v), averaged = areas("averaged", v);
    ASSERT_EQ(naive.size(), 2U);
    EXPECT_EQ(naive[0], naive[1]);
    for (std::size_t i = 0; i < 2; ++i) {
      EXPECT_EQ(constant[i], naive[i]);
      EXPECT_NEAR(averaged[i] / naive[i], 1, 1e-15);
    }
  }
}

TEST_F(VertexAreas, AveragedIsTheMeanOfTheNaiveOnesForEveryRegion) {
  for (Vertex v : mesh.vertices()) {
    const auto naive = areas("naive", v), averaged = areas("averaged", v);
    double mean = 0;
    for (double a : naive) mean += a / static_cast<double>(naive.size());
    for (double a : averaged) {
      EXPECT_NEAR(a / mean, 1, 1e-14);
      EXPECT_EQ(a, averaged[0]);
    }
    double triangles = 0;
    for (Triangle t : mesh.triangles(v)) triangles += geometry.area(t);
    EXPECT_NEAR(averaged[0], 2.0 / 3 * triangles / static_cast<double>(naive.size()), 1e-15);
  }
}

TEST_F(VertexAreas, BorderLengthIsTheAveragedOneToTheBitAlongBorders) {
  for (Vertex v : mesh.vertices()) EXPECT_EQ(areas("border-length", v), areas("averaged", v));
}

// At a Plateau vertex: the mean is the averaged area, and shares are as the three borders of each region are long.
TEST_F(VertexAreas, BorderLengthSharesOutAtAPlateauVertex) {
  mesh = quad_junction_frame(2, 0.1);
  geometry.update(mesh);
  std::size_t found = 0;
  for (Vertex v : mesh.vertices()) {
    if (geometry.regions(v).size() < 4 || !mesh.is_junction(v)) continue;
    ++found;
    const auto shared = areas("border-length", v), averaged = areas("averaged", v);
    double sum = 0, lengths = 0;
    for (std::size_t i = 0; i < 4; ++i) sum += shared[i] / 4;
    EXPECT_NEAR(sum / averaged[0], 1, 1e-14);
    std::vector<double> length(4);
    for (Edge e : mesh.edges(v))
      if (mesh.is_junction(e))
        for (std::size_t i = 0; i < 4; ++i) {
          const auto around = mesh.triangles(e);
          if (std::ranges::none_of(around, [&](Triangle t) { return mesh.labels(t).has(geometry.regions(v)[i]); }))
            continue;
          length[i] += geometry.length(e);
          lengths += geometry.length(e) / 4;
        }
    EXPECT_GT(std::ranges::max(length) - std::ranges::min(length), 0.01 * lengths);
    for (std::size_t i = 0; i < 4; ++i) EXPECT_NEAR(shared[i] / averaged[0], length[i] / lengths, 1e-13);
  }
  EXPECT_EQ(found, 1u);
}

TEST_F(VertexAreas, ConstantEdgeIsPhiTimesMeanEdgeTimesJunctionLength) {
  for (Vertex v : mesh.vertices()) {
    if (!mesh.is_junction(v)) continue;
    double length = 0;
    for (Edge e : mesh.edges(v))
      if (mesh.is_junction(e)) length += geometry.length(e);
    for (double a : areas("constant-edge", v)) EXPECT_DOUBLE_EQ(a, 0.5 * geometry.mean_edge_length() * length);
    for (double a : areas("constant-edge", v, {.phi = 0.75, .resolution = 0.3}))
      EXPECT_DOUBLE_EQ(a, 0.75 * 0.3 * length);
  }
}

TEST_F(VertexAreas, UnknownStrategyNamesTheOnesThereAre) {
  try {
    make_vertex_area("avraged", {});
    FAIL() << "no error";
  } catch (const base::InputError& error) {
    const std::string message = error.what();
    EXPECT_NE(message.find("did you mean 'averaged'"), std::string::npos) << message;
    for (const char* name : {"naive", "constant-edge"}) EXPECT_NE(message.find(name), std::string::npos) << message;
  }
}

TEST_F(VertexAreas, TheReportsThreeStrategiesAndOneMoreAreThere) {
  std::vector<std::string_view> names;
  for (const VertexAreaEntry& entry : vertex_area_strategies()) names.push_back(entry.name);
  EXPECT_EQ(names, (std::vector<std::string_view>{"naive", "constant-edge", "averaged", "border-length"}));
}

}  // namespace
}  // namespace foamsim
