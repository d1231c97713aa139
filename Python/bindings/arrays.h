#pragma once

#include <pybind11/numpy.h>

#include <span>
#include <string_view>
#include <vector>

#include "LosTopos/io/surface_data.h"

namespace foamsim::python {

/// @name Copies of a surface as NumPy arrays
///@{
/// (n, 3), float64, L.
pybind11::array vectors(std::span<const lostopos::Vec3> values);
/// (m, 3), uint32: numbers of vertices.
pybind11::array corners(std::span<const std::array<std::uint32_t, 3>> triangles);
/// (m, 2), uint32: the regions behind and in front of each triangle.
pybind11::array label_pairs(std::span<const lostopos::Labels> labels);
///@}

/// The rows of an (n, 3) array of numbers; `what` names it in messages. Throws base::InputError for another shape, or
/// where `rows` is given and is not its length.
std::vector<lostopos::Vec3> to_vectors(const pybind11::handle& array, std::string_view what,
                                       std::optional<std::size_t> rows = {});

/// A surface from arrays as above. Throws base::InputError for other shapes; what they hold is for lostopos::validate.
lostopos::SurfaceData to_surface(const pybind11::handle& positions, const pybind11::handle& triangles,
                                 const pybind11::handle& labels);

}  // namespace foamsim::python
