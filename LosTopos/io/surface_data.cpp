#include "LosTopos/io/surface_data.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "Base/error.h"
#include "LosTopos/io/surface_checks.h"

namespace lostopos {
namespace {

void require_none(const std::string& problem, const char* element, std::size_t number) {
  if (!problem.empty()) throw base::InputError(std::string(element) + " " + std::to_string(number) + ": " + problem);
}

void require(bool good, const std::string& problem) {
  if (!good) throw base::InputError(problem);
}

void validate_pairs(const SurfaceData& data, const PairArray& array) {
  const auto& [name, offsets, values] = array;
  require(offsets.size() == data.positions.size() + 1 && offsets.front() == 0 && offsets.back() == values.size() &&
              std::ranges::is_sorted(offsets),
          name + ": the offsets have to rise from 0 to the number of values, one more than there are vertices");
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    const auto mine = array.at(v);
    for (std::size_t i = 0; i < mine.size(); ++i) {
      const auto [p, q, value] = mine[i];
      const bool rising = i == 0 || std::pair(mine[i - 1].p, mine[i - 1].q) < std::pair(p, q);
      require(p < q && q.index() <= largest_region && rising && std::isfinite(value),
              name + " at vertex " + std::to_string(v) + ", pair (" + std::to_string(p.index()) + ", " +
                  std::to_string(q.index()) + "): pairs have to be p < q, ascending, each once, with a finite value");
    }
  }
}

void validate_arrays(const std::vector<DataArray>& arrays, std::size_t elements, const char* of) {
  for (const DataArray& array : arrays)
    require(array.components > 0 && array.values.size() / static_cast<std::size_t>(array.components) == elements &&
                array.values.size() % static_cast<std::size_t>(array.components) == 0,
            "array '" + array.name + "' has " + std::to_string(array.values.size()) + " numbers; " +
                std::to_string(array.components) + " for each of the " + std::to_string(elements) + " " + of +
                " would be right");
}

template <class Range>
DataArray array_of(const NamedAttributeColumn& column, const Range& living) {
  DataArray array{column.name(), column.components(), {}};
  for (const auto element : living)
    for (int i = 0; i < column.components(); ++i) array.values.push_back(column.number(element.index(), i));
  return array;
}

// One array for each column of numbers, with the values of the living elements.
template <class Range>
void append_attributes(std::span<NamedAttributeColumn* const> columns, const Range& living,
                       std::vector<DataArray>& arrays) {
  for (const NamedAttributeColumn* column : columns)
    if (column->components() > 0) arrays.push_back(array_of(*column, living));
}

template <class Range>
std::optional<DataArray> find_attribute(std::span<NamedAttributeColumn* const> columns, const Range& living,
                                        std::string_view name) {
  for (const NamedAttributeColumn* column : columns)
    if (column->name() == name && column->components() > 0) return array_of(*column, living);
  return {};
}

}  // namespace

void validate(const SurfaceData& data) {
  require(data.labels.size() == data.triangles.size(), std::to_string(data.triangles.size()) + " triangles have " +
                                                           std::to_string(data.labels.size()) + " label pairs");
  for (const std::string& problem :
       {vertex_count_problem(data.positions.size()), triangle_count_problem(data.triangles.size())})
    require(problem.empty(), problem);
  for (std::size_t v = 0; v < data.positions.size(); ++v)
    require_none(position_problem(data.positions[v]), "vertex", v);
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    const auto& [a, b, c] = data.triangles[t];
    require_none(corner_problem({a, b, c}, data.positions.size()), "triangle", t);
    require_none(label_problem(data.labels[t].p.index(), data.labels[t].q.index()), "triangle", t);
  }
  require_edges_in_range(data);
  for (const PairArray& array : data.pair_arrays) validate_pairs(data, array);
  for (std::size_t i = 0; i < data.held.size(); ++i) {
    require_none(position_problem(data.held[i].position), "held vertex", i);
    require(data.held[i].vertex < data.positions.size(),
            "held vertex " + std::to_string(i) + ": vertex " + std::to_string(data.held[i].vertex) + " does not exist");
  }
  validate_arrays(data.vertex_arrays, data.positions.size(), "vertices");
  validate_arrays(data.triangle_arrays, data.triangles.size(), "triangles");
  for (std::size_t i = 0; i < data.lines.size(); ++i)
    require(std::ranges::max(data.lines[i]) < data.positions.size(),
            "line " + std::to_string(i) + ": vertex " + std::to_string(std::ranges::max(data.lines[i])) +
                " does not exist");
}

std::uint32_t region_count(const SurfaceData& data) {
  std::uint32_t count = data.declared_regions;
  for (const Labels& labels : data.labels) count = std::max({count, labels.p.index() + 1, labels.q.index() + 1});
  for (const PairArray& array : data.pair_arrays)
    for (const PairValue& pair : array.values) count = std::max(count, pair.q.index() + 1);
  return count;
}

SurfaceMesh to_mesh(const SurfaceData& data) {
  validate(data);
  SurfaceMesh mesh;
  mesh.reserve(data.positions.size(), data.triangles.size());
  for (const Vec3& position : data.positions) mesh.add_vertex(position);
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    const auto& [a, b, c] = data.triangles[t];
    mesh.add_triangle(Vertex(a), Vertex(b), Vertex(c), data.labels[t]);
  }
  return mesh;
}

SurfaceData from_mesh(const SurfaceMesh& mesh) {
  SurfaceData data;
  const std::vector<std::uint32_t> number = compact_numbers(mesh);
  data.positions.reserve(mesh.vertex_count());
  for (const Vertex v : mesh.vertices()) data.positions.push_back(mesh.position(v));
  data.triangles.reserve(mesh.triangle_count());
  data.labels.reserve(mesh.triangle_count());
  for (const Triangle t : mesh.triangles()) {
    const auto& [a, b, c] = mesh.vertices(t);
    data.triangles.push_back({number[a.index()], number[b.index()], number[c.index()]});
    data.labels.push_back(mesh.labels(t));
  }
  return data;
}

SurfaceData from_mesh_with_solids(const SurfaceMesh& mesh) {
  SurfaceData data = from_mesh(mesh);
  auto solid = find_attribute(mesh.named_triangle_attributes(), mesh.triangles(), solid_array);
  if (solid && std::ranges::any_of(solid->values, [](double value) { return value != 0; }))
    data.triangle_arrays.push_back(*std::move(solid));
  return data;
}

std::optional<DataArray> vertex_array(const SurfaceMesh& mesh, std::string_view name) {
  return find_attribute(mesh.named_vertex_attributes(), mesh.vertices(), name);
}

SurfaceData from_mesh_with_attributes(const SurfaceMesh& mesh) {
  SurfaceData data = from_mesh(mesh);
  append_attributes(mesh.named_vertex_attributes(), mesh.vertices(), data.vertex_arrays);
  append_attributes(mesh.named_triangle_attributes(), mesh.triangles(), data.triangle_arrays);
  return data;
}

const PairArray* find_pair_array(const SurfaceData& data, std::string_view name) {
  const auto found = std::ranges::find(data.pair_arrays, name, &PairArray::name);
  return found == data.pair_arrays.end() ? nullptr : &*found;
}

const DataArray* find_array(std::span<const DataArray> arrays, std::string_view name) {
  const auto found = std::ranges::find(arrays, name, &DataArray::name);
  return found == arrays.end() ? nullptr : &*found;
}

bool holds_vertex_ids(const DataArray& array) {
  constexpr double most = std::numeric_limits<std::int32_t>::max();
  return array.components == 1 && std::ranges::all_of(array.values, [](double value) {
           return std::abs(value) <= most && value == std::floor(value);
         });
}

std::vector<std::uint32_t> compact_numbers(const SurfaceMesh& mesh) {
  std::vector<std::uint32_t> numbers(mesh.vertex_slots(), Vertex::invalid_index);
  std::uint32_t next = 0;
  for (const Vertex v : mesh.vertices()) numbers[v.index()] = next++;
  return numbers;
}

}  // namespace lostopos
