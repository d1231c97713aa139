#pragma once

#include <array>
#include <cstddef>

#include "FoamSim/sheet/velocity/tree/chebyshev.h"
#include "FoamSim/sheet/velocity/tree/tree_kernel.h"

namespace foamsim {

/// Half the sides of a cluster's box, in the units of its points; 1 where it has no length.
using HalfSides = std::array<double, 3>;

/// Adds charges on a leaf's grid (3 arrays, x outermost) whose interpolants act far away as the points do.
void add_leaf_charges(const HalfSides& half, const TreeBodies<double>& points, const Chebyshev& nodes, double* charges);
void add_leaf_charges(const HalfSides& half, const TreeBodies<float>& points, const Chebyshev& nodes, float* charges);

/// Adds what the interpolant of a potential on a leaf's grid (3 arrays) gives to points: itself, its curl, its gradient
/// times the points' strengths, to out[c · stride + i] as add_to_targets does. One thread, the best instruction set of
/// the machine, the same bits with any.
void add_interpolated(const HalfSides& half, const TreeBodies<double>& points, const Chebyshev& nodes,
                      const double* potential, TreeTerms terms, double* out, std::size_t stride);
void add_interpolated(const HalfSides& half, const TreeBodies<float>& points, const Chebyshev& nodes,
                      const double* potential, TreeTerms terms, double* out, std::size_t stride);

}  // namespace foamsim
