#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "FoamSim/scenes/scene.h"
#include "LosTopos/mesh/audit.h"
#include "LosTopos/mesh/measures.h"

namespace foamsim::test {

struct StartCounts {
  std::size_t vertices, triangles, open_edges = 0, regions = 2, held = 0, solid = 0;
};

/// What a built-in scene with these options starts from.
class StartMesh {
 public:
  explicit StartMesh(const std::string& scene, const std::vector<std::string>& assignments = {})
      : simulation_(make_simulation(with(scene, assignments))) {
    for (lostopos::Vertex v : mesh().vertices())
      if (lostopos::is_held(simulation_.held()[v.index()])) held_.push_back(v);
  }

  const lostopos::SurfaceMesh& mesh() const { return simulation_.mesh(); }
  const std::vector<lostopos::Vertex>& held() const { return held_; }
  bool is_solid(lostopos::Triangle t) const { return simulation_.solid()[t.index()] != 0; }
  double area() const { return lostopos::total_area(mesh()); }
  double volume(int region) const {
    for (const auto& [r, volume] : lostopos::region_volumes(mesh()))
      if (r == lostopos::Region(region)) return volume;
    return 0;
  }
  std::vector<lostopos::Vec3> positions() const {
    std::vector<lostopos::Vec3> all;
    for (lostopos::Vertex v : mesh().vertices()) all.push_back(mesh().position(v));
    return all;
  }

  /// And that an audit finds nothing.
  void expect_counts(const StartCounts& counts) const {
    EXPECT_EQ(mesh().vertex_count(), counts.vertices);
    EXPECT_EQ(mesh().triangle_count(), counts.triangles);
    EXPECT_EQ(lostopos::open_edge_count(mesh()), counts.open_edges);
    EXPECT_EQ(lostopos::regions(mesh()).size(), counts.regions);
    EXPECT_EQ(held_.size(), counts.held);
    EXPECT_EQ(std::ranges::count_if(mesh().triangles(), [this](lostopos::Triangle t) { return is_solid(t); }),
              static_cast<std::ptrdiff_t>(counts.solid));
    EXPECT_EQ(lostopos::audit(mesh(), {.closed_regions = counts.open_edges == 0}).text(), "clean");
  }
  /// There is a vertex at each of these, and nowhere else.
  void expect_positions(const std::vector<lostopos::Vec3>& expected) const {
    EXPECT_EQ(mesh().vertex_count(), expected.size());
    expect_among_positions(expected);
  }
  void expect_among_positions(const std::vector<lostopos::Vec3>& expected) const {
    const std::vector<lostopos::Vec3> all = positions();
    for (const lostopos::Vec3& x : expected) EXPECT_TRUE(has(all, x)) << "no vertex at " << x.transpose();
  }
  void expect_held_at(const std::vector<lostopos::Vec3>& expected) const {
    EXPECT_EQ(held_.size(), expected.size());
    std::vector<lostopos::Vec3> all;
    for (lostopos::Vertex v : held_) all.push_back(mesh().position(v));
    for (const lostopos::Vec3& x : expected) EXPECT_TRUE(has(all, x)) << "nothing held at " << x.transpose();
  }

 private:
  static Scene with(const std::string& name, const std::vector<std::string>& assignments) {
    Scene scene = built_in_scene(name);
    for (const std::string& assignment : assignments) scene.options.set_assignment(assignment, "test");
    return scene;
  }
  static bool has(const std::vector<lostopos::Vec3>& points, const lostopos::Vec3& x) {
    return std::ranges::any_of(points, [&x](const lostopos::Vec3& p) { return (p - x).norm() < 1e-12; });
  }

  Simulation simulation_;
  std::vector<lostopos::Vertex> held_;
};

}  // namespace foamsim::test
