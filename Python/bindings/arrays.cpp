#include "Python/bindings/arrays.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <vector>

#include "Base/error.h"

namespace foamsim::python {

namespace py = pybind11;

namespace {

template <class T, class Row>
py::array rows_of(std::span<const Row> values, std::size_t columns) {
  py::array_t<T> array({values.size(), columns});
  T* out = array.mutable_data();
  for (const Row& row : values) out = std::copy_n(std::begin(row), columns, out);
  return array;
}

template <class T>
using Dense = py::array_t<T, py::array::c_style | py::array::forcecast>;

template <class T>
Dense<T> table(const py::handle& given, std::size_t columns, std::string_view what) {
  Dense<T> array = Dense<T>::ensure(given);
  if (!array) {
    PyErr_Clear();
    throw base::InputError(std::string(what) + ": not an array of numbers");
  }
  if (array.ndim() != 2 || static_cast<std::size_t>(array.shape(1)) != columns)
    throw base::InputError(std::string(what) + ": an array of shape (n, " + std::to_string(columns) + ") is needed");
  return array;
}

std::uint32_t number(std::int64_t value, std::string_view what) {
  if (value < 0 || value > lostopos::largest_region)
    throw base::InputError(std::string(what) + ": " + std::to_string(value) + " is not a whole number from 0 to " +
                           std::to_string(lostopos::largest_region));
  return static_cast<std::uint32_t>(value);
}

}  // namespace

py::array vectors(std::span<const lostopos::Vec3> values) {
  return rows_of<double>(values, 3);
}

py::array corners(std::span<const std::array<std::uint32_t, 3>> triangles) {
  return rows_of<std::uint32_t>(triangles, 3);
}

py::array label_pairs(std::span<const lostopos::Labels> labels) {
  std::vector<std::array<std::uint32_t, 2>> rows;
  rows.reserve(labels.size());
  for (const lostopos::Labels& each : labels) rows.push_back({each.p.index(), each.q.index()});
  return rows_of<std::uint32_t>(std::span<const std::array<std::uint32_t, 2>>(rows), 2);
}

std::vector<lostopos::Vec3> to_vectors(const py::handle& array, std::string_view what,
                                       std::optional<std::size_t> rows) {
  const Dense<double> values = table<double>(array, 3, what);
  const auto n = static_cast<std::size_t>(values.shape(0));
  if (rows && *rows != n)
    throw base::InputError(std::string(what) + ": " + std::to_string(n) + " rows, where there are " +
                           std::to_string(*rows) + " vertices");
  std::vector<lostopos::Vec3> result(n);
  for (std::size_t i = 0; i < n; ++i)
    result[i] = {values.data()[3 * i], values.data()[3 * i + 1], values.data()[3 * i + 2]};
  return result;
}

lostopos::SurfaceData to_surface(const py::handle& positions, const py::handle& triangles, const py::handle& labels) {
  lostopos::SurfaceData data;
  data.positions = to_vectors(positions, "positions");
  const auto corner = table<std::int64_t>(triangles, 3, "triangles");
  const auto label = table<std::int64_t>(labels, 2, "labels");
  const auto n = static_cast<std::size_t>(corner.shape(0));
  if (static_cast<std::size_t>(label.shape(0)) != n)
    throw base::InputError("labels: one row a triangle is needed, " + std::to_string(n) + " in all");
  for (std::size_t t = 0; t < n; ++t) {
    const std::int64_t* c = corner.data() + 3 * t;
    const std::int64_t* l = label.data() + 2 * t;
    data.triangles.push_back({number(c[0], "triangles"), number(c[1], "triangles"), number(c[2], "triangles")});
    data.labels.push_back({lostopos::Region(number(l[0], "labels")), lostopos::Region(number(l[1], "labels"))});
  }
  return data;
}

}  // namespace foamsim::python
