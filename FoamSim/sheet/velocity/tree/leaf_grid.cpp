#include "FoamSim/sheet/velocity/tree/leaf_grid.h"

// Highway compiles the part between HWY_BEFORE_NAMESPACE and HWY_AFTER_NAMESPACE once for each instruction set. Loops
// are the compiler's to put into its lanes: none of them adds up across lanes, so that they round alike in all sets.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "FoamSim/sheet/velocity/tree/leaf_grid.cpp"
#include <hwy/foreach_target.h>  // must come before highway.h
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace foamsim::HWY_NAMESPACE {
namespace {

constexpr std::size_t most_plane = most_nodes * most_nodes;

// out[i] += weight · in[i].
template <class Real>
HWY_INLINE void add_scaled(Real weight, const Real* HWY_RESTRICT in, std::size_t count, Real* HWY_RESTRICT out) {
  for (std::size_t i = 0; i < count; ++i) out[i] += weight * in[i];
}

// By axis: the Lagrange polynomials at a point of the box, and their slopes in the points' units.
struct PointWeights {
  Chebyshev::Values value[3], slope[3];
};

template <class Real>
void take_weights(const HalfSides& half, const TreeBodies<Real>& points, std::size_t i, const Chebyshev& nodes,
                  bool slopes, PointWeights& weights) {
  const Real x[3] = {points.x[i], points.y[i], points.z[i]};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    nodes.values(static_cast<double>(x[axis]) / half[axis], weights.value[axis]);
    if (!slopes) continue;
    nodes.slopes(weights.value[axis], weights.slope[axis]);
    for (std::size_t k = 0; k < nodes.size(); ++k) weights.slope[axis][k] /= half[axis];
  }
}

template <class Real>
void charge_leaf(const HalfSides& half, const TreeBodies<Real>& points, const Chebyshev& nodes, Real* charges) {
  const std::size_t n = nodes.size(), plane = n * n;
  PointWeights weights{};
  Real product[most_plane] = {};
  for (std::size_t i = 0; i < points.size; ++i) {
    take_weights(half, points, i, nodes, false, weights);
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t k = 0; k < n; ++k)
        product[j * n + k] = static_cast<Real>(weights.value[1][j] * weights.value[2][k]);
    const Real strength[3] = {points.gx[i], points.gy[i], points.gz[i]};
    for (std::size_t part = 0; part < 3; ++part)
      for (std::size_t x = 0; x < n; ++x)
        add_scaled(static_cast<Real>(weights.value[0][x]) * strength[part], product, plane,
                   charges + (part * n + x) * plane);
  }
}

// The value of one component, and its derivatives along x, y and z where they are wanted.
template <bool derivatives>
HWY_INLINE void interpolate(const double* HWY_RESTRICT grid, std::size_t n, const PointWeights& w, double (&got)[4]) {
  const std::size_t plane = n * n;
  double sums[most_plane], along[most_plane];
  for (std::size_t j = 0; j < plane; ++j) sums[j] = along[j] = 0;
  for (std::size_t a = 0; a < n; ++a) {
    add_scaled(w.value[0][a], grid + a * plane, plane, sums);
    if constexpr (derivatives) add_scaled(w.slope[0][a], grid + a * plane, plane, along);
  }
  double row[most_nodes] = {}, row_x[most_nodes] = {}, row_y[most_nodes] = {};
  for (std::size_t b = 0; b < n; ++b) {
    add_scaled(w.value[1][b], sums + b * n, n, row);
    if constexpr (derivatives) {
      add_scaled(w.value[1][b], along + b * n, n, row_x);
      add_scaled(w.slope[1][b], sums + b * n, n, row_y);
    }
  }
  for (double& each : got) each = 0;
  for (std::size_t d = 0; d < n; ++d) {
    got[0] += w.value[2][d] * row[d];
    if constexpr (derivatives) {
      got[1] += w.value[2][d] * row_x[d];
      got[2] += w.value[2][d] * row_y[d];
      got[3] += w.slope[2][d] * row[d];
    }
  }
}

template <class Real>
void interpolate_leaf(const HalfSides& half, const TreeBodies<Real>& points, const Chebyshev& nodes,
                      const double* potential, TreeTerms terms, double* out, std::size_t stride) {
  const std::size_t n = nodes.size(), size = n * n * n;
  const bool derivatives = terms != TreeTerms::potential;
  PointWeights weights{};
  for (std::size_t i = 0; i < points.size; ++i) {
    take_weights(half, points, i, nodes, derivatives, weights);
    double got[3][4];
    for (std::size_t part = 0; part < 3; ++part) {
      const double* grid = potential + part * size;
      derivatives ? interpolate<true>(grid, n, weights, got[part]) : interpolate<false>(grid, n, weights, got[part]);
    }
    double* at = out + i;
    const auto add = [&at, stride](double value) {
      *at += value;
      at += stride;
    };
    if (terms != TreeTerms::velocity)
      for (std::size_t part = 0; part < 3; ++part) add(got[part][0]);
    if (!derivatives) continue;
    add(got[2][2] - got[1][3]);
    add(got[0][3] - got[2][1]);
    add(got[1][1] - got[0][2]);
    if (terms != TreeTerms::all) continue;
    const double gx = points.gx[i], gy = points.gy[i], gz = points.gz[i];
    for (std::size_t axis = 1; axis <= 3; ++axis) add(gx * got[0][axis] + gy * got[1][axis] + gz * got[2][axis]);
  }
}

void charge_doubles(const HalfSides& half, const TreeBodies<double>& points, const Chebyshev& nodes, double* charges) {
  charge_leaf(half, points, nodes, charges);
}

void charge_singles(const HalfSides& half, const TreeBodies<float>& points, const Chebyshev& nodes, float* charges) {
  charge_leaf(half, points, nodes, charges);
}

void interpolate_doubles(const HalfSides& half, const TreeBodies<double>& points, const Chebyshev& nodes,
                         const double* potential, TreeTerms terms, double* out, std::size_t stride) {
  interpolate_leaf(half, points, nodes, potential, terms, out, stride);
}

void interpolate_singles(const HalfSides& half, const TreeBodies<float>& points, const Chebyshev& nodes,
                         const double* potential, TreeTerms terms, double* out, std::size_t stride) {
  interpolate_leaf(half, points, nodes, potential, terms, out, stride);
}

}  // namespace
}  // namespace foamsim::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace foamsim {

HWY_EXPORT(charge_doubles);
HWY_EXPORT(charge_singles);
HWY_EXPORT(interpolate_doubles);
HWY_EXPORT(interpolate_singles);

void add_leaf_charges(const HalfSides& half, const TreeBodies<double>& points, const Chebyshev& nodes,
                      double* charges) {
  HWY_DYNAMIC_DISPATCH(charge_doubles)(half, points, nodes, charges);
}

void add_leaf_charges(const HalfSides& half, const TreeBodies<float>& points, const Chebyshev& nodes, float* charges) {
  HWY_DYNAMIC_DISPATCH(charge_singles)(half, points, nodes, charges);
}

void add_interpolated(const HalfSides& half, const TreeBodies<double>& points, const Chebyshev& nodes,
                      const double* potential, TreeTerms terms, double* out, std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(interpolate_doubles)(half, points, nodes, potential, terms, out, stride);
}

void add_interpolated(const HalfSides& half, const TreeBodies<float>& points, const Chebyshev& nodes,
                      const double* potential, TreeTerms terms, double* out, std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(interpolate_singles)(half, points, nodes, potential, terms, out, stride);
}

}  // namespace foamsim
#endif  // HWY_ONCE
