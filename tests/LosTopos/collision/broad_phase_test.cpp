#include "LosTopos/collision/broad_phase.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "tests/support/sample_meshes.h"

namespace lostopos {
namespace {

using Held = std::map<Triangle, Box>;

std::vector<Triangle> brute_force(const Held& held, const Box& box) {
  std::vector<Triangle> found;
  for (const auto& [t, other] : held) {
    if (other.overlaps(box)) found.push_back(t);
  }
  return found;
}

// Boxes of very different sizes, flat ones and points among them, some on a coarse lattice so that many just touch.
class RandomBoxes {
 public:
  RandomBoxes(double unit, const Vec3& origin, unsigned seed) : unit_(unit), origin_(origin), random_(seed) {}

  Box next() {
    Vec3 low, size;
    for (int i = 0; i < 3; ++i) low[i] = std::uniform_real_distribution(0.0, 10.0)(random_);
    const double scale = std::exp2(std::uniform_real_distribution(-14.0, 3.0)(random_));
    for (int i = 0; i < 3; ++i) size[i] = pick(4) == 0 ? 0 : scale * std::uniform_real_distribution(0.1, 1.0)(random_);
    if (pick(2) == 0) {
      low = low.array().round();
      size = size.array().ceil();
    }
    return {origin_ + unit_ * low, origin_ + unit_ * (low + size)};
  }
  std::size_t pick(std::size_t count) { return std::uniform_int_distribution<std::size_t>(0, count - 1)(random_); }

 private:
  double unit_;
  Vec3 origin_;
  std::mt19937 random_;
};

void edit_and_compare(RandomBoxes boxes, int edits) {
  BroadPhase phase;
  Held held;
  std::size_t hits = 0;
  for (int i = 0; i < edits; ++i) {
    const Triangle t(boxes.pick(400));
    if (boxes.pick(3) == 0) {
      phase.remove(t);
      held.erase(t);
    } else {
      const Box box = boxes.next();
      phase.set(t, box);
      held[t] = box;
    }
    const Box box = boxes.next();
    std::vector<Triangle> found = {Triangle(7)};  // results are appended
    phase.query(box, found);
    ASSERT_EQ(found.front(), Triangle(7));
    found.erase(found.begin());
    ASSERT_EQ(found, brute_force(held, box)) << "after edit " << i;
    hits += found.size();
  }
  EXPECT_GT(hits, static_cast<std::size_t>(edits));
}

TEST(BroadPhase, FindsWhatBruteForceFinds) {
  edit_and_compare({1, Vec3::Zero(), 1}, 4000);
}

TEST(BroadPhase, FindsTheSameAtAnyScale) {
  edit_and_compare({1e-12, Vec3(-5e-12, -5e-12, 3e-12), 2}, 1500);
  edit_and_compare({1e+12, Vec3::Zero(), 3}, 1500);
  edit_and_compare({1e-300, Vec3::Zero(), 4}, 1500);
  edit_and_compare({1e+306, Vec3::Zero(), 5}, 1500);
}

// Sides that differ by one double, which single precision does not tell apart, above and below numbers that it has.
TEST(BroadPhase, TellsWhatTouchesFromWhatIsADoubleAway) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  BroadPhase phase;
  Held held;
  for (std::size_t i = 0; i < 300; ++i) {
    const double at = 1 + (static_cast<double>(i % 7) - 3) * 0x1p-24 + static_cast<double>(i % 3) * 0x1p-52;
    held[Triangle(i)] = {Vec3::Constant(0), Vec3(at, 1, at)};
  }
  // Those of the first build are laid out in single precision.
  for (const auto& [t, box] : held) phase.set(t, box);
  std::size_t met = 0, missed = 0;
  for (const auto& [t, box] : held)
    for (const double toward : {-infinity, 0.0, infinity}) {
      const double side = toward == 0 ? box.high[0] : std::nextafter(box.high[0], toward);
      const Box asked{Vec3(side, 0.5, 0.5), Vec3::Constant(2)};
      std::vector<Triangle> found;
      phase.query(asked, found);
      ASSERT_EQ(found, brute_force(held, asked)) << side - 1;
      met += found.size();
      missed += held.size() - found.size();
    }
  EXPECT_GT(met, 0u);
  EXPECT_GT(missed, 0u);
}

TEST(BroadPhase, FarFromTheOrigin) {
  edit_and_compare({1, Vec3(1e+14, -1e+14, 1e+6), 6}, 1500);
  edit_and_compare({1e-3, Vec3(1e+300, -1e+300, 0), 7}, 500);
}

TEST(BroadPhase, BoxesAsLargeAsDoublesGo) {
  BroadPhase phase;
  const double largest = std::numeric_limits<double>::max();
  phase.set(Triangle(3), {Vec3::Constant(-largest), Vec3::Constant(largest)});
  phase.set(Triangle(1), {Vec3::Zero(), Vec3::Constant(1e-9)});
  phase.set(Triangle(2), {Vec3::Constant(largest), Vec3::Constant(largest)});
  std::vector<Triangle> found;
  phase.query({Vec3::Constant(-1), Vec3::Constant(1)}, found);
  EXPECT_EQ(found, (std::vector{Triangle(1), Triangle(3)}));
  found.clear();
  phase.query({Vec3::Constant(-largest), Vec3::Constant(largest)}, found);
  EXPECT_EQ(found, (std::vector{Triangle(1), Triangle(2), Triangle(3)}));
}

// All in one cell, which has to make room for what comes and use that of what has gone.
TEST(BroadPhase, ManyBoxesInOnePlace) {
  BroadPhase phase;
  Held held;
  std::mt19937 random(5);
  const auto near_origin = [&random] {
    Vec3 low;
    for (int i = 0; i < 3; ++i) low[i] = 1 + std::uniform_real_distribution(0.0, 0.01)(random);
    return Box{low, low + Vec3(1, 1, 1)};
  };
  constexpr std::uint32_t count = 1000;
  for (std::uint32_t round = 0; round < 20; ++round) {
    for (std::uint32_t i = 0; i < count; ++i) {
      const Triangle t(i);
      if ((i * 7 + round) % 3 == 0) {
        phase.remove(t);
        held.erase(t);
      } else {
        phase.set(t, held[t] = near_origin());
      }
    }
    const Box box = near_origin();
    std::vector<Triangle> found;
    phase.query({box.low, box.low}, found);
    ASSERT_EQ(found, brute_force(held, {box.low, box.low})) << "in round " << round;
    ASSERT_LT(phase.memory_bytes(), 2000 + 500 * count);
  }
}

TEST(BroadPhase, BuildsFromAMeshInMotionAndForgetsWhatItHeld) {
  const SurfaceMesh mesh = test::globe(1, 12);
  std::vector<Vec3> to(mesh.positions().begin(), mesh.positions().end());
  for (Vec3& x : to) x += Vec3(0.3, 0.1, -0.2) * x[0];
  const double margin = 0.05;
  Held held;
  for (Triangle t : mesh.triangles()) {
    const Box a = triangle_box(mesh, t, mesh.positions(), margin);
    const Box b = triangle_box(mesh, t, to, margin);
    held[t] = {a.low.cwiseMin(b.low), a.high.cwiseMax(b.high)};
  }
  BroadPhase phase;
  phase.set(Triangle(100000), {Vec3::Zero(), Vec3::Ones()});
  phase.build(mesh, mesh.positions(), to, margin);
  for (const auto& [t, box] : held) {
    std::vector<Triangle> found;
    phase.query(box, found);
    ASSERT_EQ(found, brute_force(held, box));
  }
}

TEST(BroadPhase, MemoryGrowsWithTheTrianglesNotWithTheirExtent) {
  BroadPhase phase;
  for (std::size_t i = 0; i < 10000; ++i) {
    const Vec3 low(static_cast<double>(i) * 1e6, 0, 0);
    phase.set(Triangle(i), {low, low + Vec3::Ones()});
  }
  EXPECT_LT(phase.memory_bytes(), 10000u * 256u);
}

}  // namespace
}  // namespace lostopos
