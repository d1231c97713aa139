#include "FoamSim/app/frame_fields.h"

#include <cmath>

#include "Base/error.h"
#include "FoamSim/statistics/bubble_pressures.h"
#include "LosTopos/io/film_faces.h"

namespace foamsim::app {

using lostopos::DataArray;
using lostopos::SurfaceData;

namespace {

double value_at(const DataArray& array, std::size_t element) {
  const auto components = static_cast<std::size_t>(array.components);
  if (components == 1) return array.values[element];
  double squares = 0;
  for (std::size_t i = 0; i < components; ++i) squares += std::pow(array.values[components * element + i], 2);
  return std::sqrt(squares);
}

std::vector<double> pressure_jumps(const SurfaceData& data) {
  const lostopos::SurfaceMesh mesh = lostopos::to_mesh(data);
  const std::vector<std::uint8_t> solid = lostopos::solid_triangles(data);
  const auto pressures = bubble_pressures(mesh, bubbles_of_films(mesh, solid), solid);
  const auto pressure = [&pressures](lostopos::Region r) {
    const auto found = pressures.find(r);
    return found == pressures.end() ? 0.0 : found->second;
  };
  std::vector<double> jumps;
  for (const lostopos::Labels& pq : data.labels)
    jumps.insert(jumps.end(), 3, std::abs(pressure(pq.p) - pressure(pq.q)));
  return jumps;
}

std::string known_fields(const SurfaceData& data) {
  std::string names;
  for (const auto* arrays : {&data.vertex_arrays, &data.triangle_arrays})
    for (const DataArray& array : *arrays) names += array.name + ", ";
  return names + "pressure";
}

}  // namespace

std::vector<double> field_values(const SurfaceData& data, const std::string& field) {
  std::vector<double> values;
  if (const DataArray* array = lostopos::find_array(data.triangle_arrays, field)) {
    for (std::size_t t = 0; t < data.triangles.size(); ++t) values.insert(values.end(), 3, value_at(*array, t));
    return values;
  }
  if (const DataArray* array = lostopos::find_array(data.vertex_arrays, field)) {
    for (const auto& triangle : data.triangles)
      for (const std::uint32_t v : triangle) values.push_back(value_at(*array, v));
    return values;
  }
  if (field == "pressure") return pressure_jumps(data);
  throw base::InputError("no field '" + field + "' to colour by; there are regions (no field), " + known_fields(data));
}

}  // namespace foamsim::app
