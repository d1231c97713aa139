#include "FoamSim/web/frame_fields.h"

#include <algorithm>
#include <cmath>

#include "Base/error.h"
#include "Base/names/nearest_name.h"

namespace foamsim::web {
namespace {

void put(std::vector<FrameField>& fields, FrameField field) {
  const auto same = std::ranges::find(fields, field.name, &FrameField::name);
  if (same == fields.end())
    fields.push_back(std::move(field));
  else
    *same = std::move(field);
}

FrameField field_from(const lostopos::DataArray& array, bool on_vertices) {
  const auto components = static_cast<std::size_t>(std::max(1, array.components));
  FrameField field{array.name, on_vertices, {}};
  if (components == 1) {
    field.values = array.values;
    return field;
  }
  for (std::size_t i = 0; i + components <= array.values.size(); i += components) {
    double squares = 0;
    for (std::size_t k = 0; k < components; ++k) squares += array.values[i + k] * array.values[i + k];
    field.values.push_back(std::sqrt(squares));
  }
  return field;
}

}  // namespace

std::vector<FrameField> fields_of(const lostopos::SurfaceData& surface, const SurfaceMeasures& measures) {
  std::vector<FrameField> fields{{"mean_curvature", false, measures.mean_curvature},
                                 {"pressure_jump", false, measures.pressure_jump}};
  for (const lostopos::DataArray& array : surface.triangle_arrays)
    if (array.name != "solid") put(fields, field_from(array, false));
  for (const lostopos::DataArray& array : surface.vertex_arrays) put(fields, field_from(array, true));
  return fields;
}

std::vector<FrameField> chosen_fields(std::vector<FrameField> fields, const std::vector<std::string>& names) {
  if (names.empty()) return fields;
  std::vector<FrameField> chosen;
  if (names == std::vector<std::string>{"none"}) return chosen;
  for (const std::string& name : names) put(chosen, base::find_by_name(fields, name, "field"));
  return chosen;
}

}  // namespace foamsim::web
