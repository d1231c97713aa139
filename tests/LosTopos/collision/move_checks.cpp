#include "tests/LosTopos/collision/move_checks.h"

#include <gtest/gtest.h>

#include <cstdio>

#include "LosTopos/mesh/audit.h"

namespace lostopos::test {

std::vector<Vertex> add_part(SurfaceMesh& mesh, const SurfaceMesh& part, Region inside,
                             const std::function<Vec3(const Vec3&)>& map) {
  std::vector<Vertex> added(part.vertex_slots());
  for (Vertex v : part.vertices()) added[v.index()] = mesh.add_vertex(map(part.position(v)));
  const auto renamed = [inside](Region r) { return r == Region(1) ? inside : r; };
  for (Triangle t : part.triangles()) {
    const auto& [a, b, c] = part.vertices(t);
    mesh.add_triangle(added[a.index()], added[b.index()], added[c.index()],
                      {renamed(part.labels(t).p), renamed(part.labels(t).q)});
  }
  return added;
}

std::vector<Vertex> add_sheet(SurfaceMesh& mesh, long n, const Vec3& corner, const Vec3& u, const Vec3& v,
                              Labels labels) {
  std::vector<Vertex> added;
  const double step = 1 / static_cast<double>(n);
  for (long j = 0; j <= n; ++j) {
    for (long i = 0; i <= n; ++i) {
      added.push_back(mesh.add_vertex(corner + step * static_cast<double>(i) * u + step * static_cast<double>(j) * v));
    }
  }
  for (long j = 0; j < n; ++j) {
    for (long i = 0; i < n; ++i) {
      const auto at = [&](long di, long dj) { return added[static_cast<std::size_t>((j + dj) * (n + 1) + i + di)]; };
      mesh.add_triangle(at(0, 0), at(1, 0), at(1, 1), labels);
      mesh.add_triangle(at(0, 0), at(1, 1), at(0, 1), labels);
    }
  }
  return added;
}

std::vector<Vec3> positions_of(const SurfaceMesh& mesh) {
  return {mesh.positions().begin(), mesh.positions().end()};
}

bool move_and_check(SurfaceMesh& mesh, const std::vector<Vec3>& predicted, const std::vector<Hold>& held,
                    const MoveOptions& options, MoveStatistics& sum, bool closed) {
  const std::vector<Vec3> before = positions_of(mesh);
  const MoveResult result = move_safely(mesh, predicted, held, options);
  sum += result.statistics;
  bool good = true;
  for (Vertex v : mesh.vertices()) {
    if (held.empty() || held[v.index()] == Hold::none) continue;
    const std::size_t i = v.index();
    const Vec3 asked =
        result.fraction == 1 ? predicted[i] : Vec3((1 - result.fraction) * before[i] + result.fraction * predicted[i]);
    good &= mesh.position(v) == asked;
  }
  EXPECT_TRUE(good) << "a held vertex is off its path";
  AuditOptions audit_options;
  audit_options.closed_regions = closed;
  const AuditReport report = audit(mesh, audit_options);
  EXPECT_TRUE(report.clean()) << report.text();
  return good && report.clean();
}

void print(const char* what, const MoveStatistics& s) {
  std::printf(
      "  %s: %zu pairs, %zu proximities, %zu collisions, %zu impulses, %zu inelastic zones, %zu rigid zones, largest "
      "%zu, %zu halvings; broad phase %.3f s, ccd %.3f s, impulses %.3f s, zones %.3f s\n",
      what, s.pairs, s.proximities, s.collisions, s.impulses, s.inelastic_zones, s.rigid_zones, s.largest_zone,
      s.halvings, s.broad_phase_seconds, s.ccd_seconds, s.impulse_seconds, s.zone_seconds);
}

}  // namespace lostopos::test
