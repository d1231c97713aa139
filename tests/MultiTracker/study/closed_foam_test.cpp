// What a run until closed leaves, by an oracle that knows nothing of genus and pockets: a grid of places for a ball.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "LosTopos/geometry/distance.h"
#include "LosTopos/io/mesh_file.h"
#include "LosTopos/io/surface_data.h"
#include "LosTopos/mesh/measures.h"
#include "LosTopos/shapes/sphere_layout.h"
#include "MultiTracker/study/robustness.h"
#include "tests/support/scratch_folder.h"

namespace multitracker {
namespace {

namespace fs = std::filesystem;
using lostopos::SurfaceMesh;
using lostopos::Vec3;

// Points a quarter of the ball's diameter apart at which its centre may be without that it touches a film.
class BallGrid {
 public:
  BallGrid(const SurfaceMesh& mesh, double diameter) : cell_(diameter / 4) {
    Vec3 low = Vec3::Constant(HUGE_VAL), high = -low;
    for (lostopos::Vertex v : mesh.vertices()) {
      low = low.cwiseMin(mesh.position(v));
      high = high.cwiseMax(mesh.position(v));
    }
    low_ = low.array() - 2 * diameter;
    for (int i = 0; i < 3; ++i) n_[i] = static_cast<long>((high[i] - low_[i] + 2 * diameter) / cell_);
    is_free_.assign(static_cast<std::size_t>(n_[0] * n_[1] * n_[2]), 1);
    for (lostopos::Triangle t : mesh.triangles()) take_away_near(lostopos::corners(mesh, t), diameter / 2);
  }

  // Parts of what is free that have more than a few points: fewer lie in every groove.
  std::size_t count_parts() {
    std::size_t parts = 0;
    for (std::size_t i = 0; i < is_free_.size(); ++i)
      if (is_free_[i] != 0 && take_part(i) > 8) ++parts;
    return parts;
  }

 private:
  void take_away_near(const std::array<Vec3, 3>& corners, double radius) {
    const auto& [a, b, c] = corners;
    std::array<long, 3> first, last;
    for (int i = 0; i < 3; ++i) {
      first[i] = static_cast<long>(std::ceil((std::min({a[i], b[i], c[i]}) - radius - low_[i]) / cell_));
      last[i] = static_cast<long>((std::max({a[i], b[i], c[i]}) + radius - low_[i]) / cell_);
    }
    for (long z = first[2]; z <= last[2]; ++z)
      for (long y = first[1]; y <= last[1]; ++y)
        for (long x = first[0]; x <= last[0]; ++x) {
          const Vec3 p = low_ + cell_ * Vec3(static_cast<double>(x), static_cast<double>(y), static_cast<double>(z));
          if (lostopos::point_triangle_distance(p, a, b, c).distance < radius) is_free_[index(x, y, z)] = 0;
        }
  }

  std::size_t take_part(std::size_t first) {
    std::vector<std::size_t> part{first};
    is_free_[first] = 0;
    const std::array<std::size_t, 3> strides = {1, static_cast<std::size_t>(n_[0]),
                                                static_cast<std::size_t>(n_[0] * n_[1])};
    for (std::size_t i = 0; i < part.size(); ++i)
      for (std::size_t stride : strides)
        for (const std::size_t next : {part[i] - stride, part[i] + stride}) {
          if (next >= is_free_.size() || is_free_[next] == 0) continue;  // rows run into each other, outside only
          is_free_[next] = 0;
          part.push_back(next);
        }
    return part.size();
  }

  std::size_t index(long x, long y, long z) const { return static_cast<std::size_t>(x + n_[0] * (y + n_[1] * z)); }

  double cell_;
  Vec3 low_;
  std::array<long, 3> n_;
  std::vector<char> is_free_;
};

SurfaceMesh last_frame(const fs::path& run) {
  std::vector<fs::path> frames;
  for (const auto& entry : fs::directory_iterator(run / "frames"))
    if (entry.path().extension() == ".ply") frames.push_back(entry.path());
  return lostopos::to_mesh(lostopos::read_surface(*std::ranges::max_element(frames)));
}

TEST(BallGrid, HasAPartForTheOutsideAndForEveryHollow) {
  const SurfaceMesh spheres = lostopos::sphere_meshes({{Vec3::Zero(), 2}, {Vec3(1, 0, 0), 0.5}, {Vec3(6, 0, 0), 1.5}});
  EXPECT_EQ(BallGrid(spheres, 0.4).count_parts(), 4u);
  EXPECT_EQ(BallGrid(spheres, 1.2).count_parts(), 3u);
}

// The bubbles and the air outside: nowhere else is there room for a ball as thick as a mean edge is long.
TEST(RobustnessUntilClosed, LeavesNoRoomBetweenTheBubbles) {
  const ::test::ScratchFolder scratch;
  RobustnessOptions options;
  options.spheres = {8};
  options.steps = {0.2};
  options.seeds = 4;
  options.layout = "random";
  options.total_motion = 20;
  options.until_closed = true;
  options.audit_every_step = true;
  options.workers = 2;
  options.folder = scratch / "study";
  for (const RobustnessRun& run : run_robustness(options)) EXPECT_TRUE(run.success()) << run.message;
  for (const auto& run : fs::directory_iterator(options.folder / "runs")) {
    const SurfaceMesh foam = last_frame(run.path());
    EXPECT_EQ(lostopos::regions(foam).size(), 9u);
    EXPECT_EQ(BallGrid(foam, lostopos::mean_edge_length(foam)).count_parts(), 9u) << run.path();
  }
}

}  // namespace
}  // namespace multitracker
