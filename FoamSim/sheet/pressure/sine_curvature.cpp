#include "FoamSim/sheet/pressure/sine_curvature.h"

#include <Eigen/Geometry>
#include <algorithm>

namespace foamsim {

using lostopos::Edge;
using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Triangle;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

std::uint32_t curvature_entry(const SurfaceGeometry& geometry, Vertex v, Region r) {
  const auto regions = geometry.regions(v);
  return static_cast<std::uint32_t>(geometry.first_entry(v)) +
         static_cast<std::uint32_t>(std::ranges::lower_bound(regions, r) - regions.begin());
}

// κ of a hinge, and its gradient at the four vertices; all 0 where a triangle has no area.
struct HingeTerm {
  double kappa = 0;
  std::array<Vec3, 4> gradient{Vec3::Zero(), Vec3::Zero(), Vec3::Zero(), Vec3::Zero()};
};

HingeTerm hinge_term(const Vec3& x0, const Vec3& x1, const Vec3& first, const Vec3& second) {
  const Vec3 e = x1 - x0, a = first - x0, b = second - x0;
  const Vec3 m0 = e.cross(a), m1 = b.cross(e);
  const double square0 = m0.squaredNorm(), square1 = m1.squaredNorm(), scale = std::sqrt(square0 * square1);
  HingeTerm term;
  if (!(scale > 0)) return term;
  term.kappa = m0.cross(m1).dot(e) / scale;
  const Vec3 g0 = m1.cross(e) / scale - term.kappa / square0 * m0;
  const Vec3 g1 = e.cross(m0) / scale - term.kappa / square1 * m1;
  term.gradient[1] = m0.cross(m1) / scale + a.cross(g0) + g1.cross(b);
  term.gradient[2] = g0.cross(e);
  term.gradient[3] = e.cross(g1);
  term.gradient[0] = -(term.gradient[1] + term.gradient[2] + term.gradient[3]);
  return term;
}

}  // namespace

SineCurvature::SineCurvature(const SurfaceMesh& mesh, const SurfaceGeometry& geometry)
    : entries_(geometry.entries()), columns_(static_cast<Eigen::Index>(3 * mesh.vertex_slots())) {
  for (Triangle t : mesh.triangles())
    for (Region r : {mesh.labels(t).p, mesh.labels(t).q}) {
      Side side{};
      for (std::size_t k = 0; k < 3; ++k) {
        side.vertices[k] = mesh.vertices(t)[k].index();
        side.entries[k] = curvature_entry(geometry, mesh.vertices(t)[k], r);
      }
      sides_.push_back(side);
    }
  for (Edge e : mesh.edges())
    for (const RegionEdgeCurvature& own : geometry.curvatures(e)) {
      std::array<Triangle, 2> forward_backward{};
      std::array<int, 2> count{};
      for (Triangle t : mesh.triangles(e)) {
        if (!mesh.labels(t).has(own.region)) continue;
        const std::size_t side = mesh.runs_along(t, e) == (mesh.labels(t).p == own.region) ? 0 : 1;
        forward_backward[side] = t;
        ++count[side];
      }
      if (count[0] != 1 || count[1] != 1) continue;
      const auto [a, b] = mesh.vertices(e);
      hinges_.push_back({{a.index(), b.index(), mesh.opposite_vertex(forward_backward[0], e).index(),
                          mesh.opposite_vertex(forward_backward[1], e).index()},
                         {curvature_entry(geometry, a, own.region), curvature_entry(geometry, b, own.region)}});
    }
}

std::vector<double> SineCurvature::areas(std::span<const Vec3> x) const {
  std::vector<double> areas(entries_, 0.0);
  for (const Side& side : sides_) {
    const auto [a, b, c] = side.vertices;
    const double third = (x[b] - x[a]).cross(x[c] - x[a]).norm() / 6;
    for (std::uint32_t entry : side.entries) areas[entry] += third;
  }
  return areas;
}

void SineCurvature::evaluate(std::span<const Vec3> x, std::vector<double>& curvature) const {
  const std::vector<double> areas_of = areas(x);
  curvature.assign(entries_, 0.0);
  for (const Hinge& hinge : hinges_) {
    const auto [x0, x1, first, second] = hinge.vertices;
    const double kappa = hinge_term(x[x0], x[x1], x[first], x[second]).kappa;
    for (std::uint32_t entry : hinge.entries) curvature[entry] += kappa;
  }
  for (std::size_t i = 0; i < entries_; ++i) curvature[i] = areas_of[i] > 0 ? curvature[i] / areas_of[i] : 0;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> SineCurvature::derivative(std::span<const Vec3> x) const {
  const std::vector<double> areas_of = areas(x);
  std::vector<double> curvature;
  evaluate(x, curvature);
  std::vector<Eigen::Triplet<double>> terms;
  const auto add = [&terms](std::uint32_t entry, std::uint32_t v, const Vec3& gradient) {
    for (int i = 0; i < 3; ++i) terms.emplace_back(static_cast<int>(entry), static_cast<int>(3 * v) + i, gradient[i]);
  };
  for (const Hinge& hinge : hinges_) {
    const auto [x0, x1, first, second] = hinge.vertices;
    const HingeTerm term = hinge_term(x[x0], x[x1], x[first], x[second]);
    for (std::uint32_t entry : hinge.entries)
      if (areas_of[entry] > 0)
        for (std::size_t k = 0; k < 4; ++k) add(entry, hinge.vertices[k], term.gradient[k] / areas_of[entry]);
  }
  for (const Side& side : sides_) {
    const auto& v = side.vertices;
    const Vec3 normal = (x[v[1]] - x[v[0]]).cross(x[v[2]] - x[v[0]]).normalized();
    for (std::uint32_t entry : side.entries)
      if (areas_of[entry] > 0)
        for (std::size_t k = 0; k < 3; ++k)
          add(entry, v[k],
              -curvature[entry] / areas_of[entry] / 6 * normal.cross(x[v[(k + 2) % 3]] - x[v[(k + 1) % 3]]));
  }
  Eigen::SparseMatrix<double, Eigen::RowMajor> derivative(static_cast<Eigen::Index>(entries_), columns_);
  derivative.setFromTriplets(terms.begin(), terms.end());
  return derivative;
}

}  // namespace foamsim
