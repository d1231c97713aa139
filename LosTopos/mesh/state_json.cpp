#include "LosTopos/mesh/state_json.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "Base/json/binary_json.h"
#include "Base/json/checked_json.h"

namespace lostopos {

using base::CheckedJson;
using nlohmann::json;

namespace {

template <class T>
json blob(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return base::binary_json(std::move(bytes));
}

template <class T>
std::vector<T> from_blob(const CheckedJson& value) {
  const auto& bytes = value.bytes();
  if (bytes.size() % sizeof(T) != 0) value.refuse("is cut off");
  std::vector<T> values(bytes.size() / sizeof(T));
  if (!bytes.empty()) std::memcpy(values.data(), bytes.data(), bytes.size());
  return values;
}

// Lists of handles as lengths and one flat array.
template <class Lists>
json list_blobs(const Lists& lists) {
  std::vector<std::uint32_t> lengths, elements;
  for (const auto& list : lists) {
    lengths.push_back(static_cast<std::uint32_t>(list.size()));
    for (auto element : list) elements.push_back(element.index());
  }
  return {blob(lengths), blob(elements)};
}

template <class List>
void fill(List& list, std::span<const std::uint32_t> elements, const CheckedJson& value) {
  using H = typename List::value_type;
  if constexpr (requires { list.push_back(H()); }) {
    for (std::uint32_t element : elements) list.push_back(H(element));
  } else {
    if (elements.size() != list.size())
      value.refuse("has " + std::to_string(elements.size()) + " entries where " + std::to_string(list.size()) +
                   " belong");
    for (std::size_t i = 0; i < list.size(); ++i) list[i] = H(elements[i]);
  }
}

template <class Lists>
void from_list_blobs(const CheckedJson& value, Lists& lists) {
  const auto parts = value.entries(2);
  const auto lengths = from_blob<std::uint32_t>(parts[0]), elements = from_blob<std::uint32_t>(parts[1]);
  std::span<const std::uint32_t> left(elements);
  lists.reserve(lengths.size());
  for (std::uint32_t length : lengths) {
    if (length > left.size()) value.refuse("is cut off");
    typename Lists::value_type list{};
    fill(list, left.first(length), value);
    left = left.subspan(length);
    lists.push_back(std::move(list));
  }
  if (!left.empty()) value.refuse("has elements that belong to no list");
}

json pool_json(const SlotPool& pool) {
  return {blob(pool.alive()), blob(pool.free())};
}

SlotPool pool_from(const CheckedJson& value) {
  const auto parts = value.entries(2);
  return {from_blob<char>(parts[0]), from_blob<std::uint32_t>(parts[1])};
}

json attributes_json(const std::vector<StoredAttribute>& attributes) {
  json by_name = json::object();
  for (const auto& [name, values] : attributes)
    by_name[name] = {
        {"type", values->type()}, {"count", values->size()}, {"bytes", base::binary_json(values->encoded())}};
  return by_name;
}

std::vector<StoredAttribute> attributes_from(const CheckedJson& by_name) {
  if (!by_name.json().is_object()) by_name.refuse("is not an object");
  std::vector<StoredAttribute> attributes;
  for (const auto& entry : by_name.json().items()) {
    const CheckedJson value = by_name.at(entry.key());
    attributes.emplace_back(entry.key(),
                            std::make_unique<EncodedValues>(value.at("type").text(),
                                                            static_cast<std::size_t>(value.at("count").whole_number()),
                                                            value.at("bytes").bytes()));
  }
  return attributes;
}

}  // namespace

json to_json(const SurfaceMesh::State& s) {
  std::vector<std::array<std::uint32_t, 2>> labels;
  for (const Labels& pq : s.labels) labels.push_back({pq.p.index(), pq.q.index()});
  std::vector<double> coordinates;
  for (const Vec3& x : s.positions) coordinates.insert(coordinates.end(), x.begin(), x.end());
  return {{"vertices", pool_json(s.vertices)},
          {"edges", pool_json(s.edges)},
          {"triangles", pool_json(s.triangles)},
          {"positions", blob(coordinates)},
          {"vertex_edges", list_blobs(s.vertex_edges)},
          {"vertex_triangles", list_blobs(s.vertex_triangles)},
          {"edge_vertices", list_blobs(s.edge_vertices)},
          {"edge_triangles", list_blobs(s.edge_triangles)},
          {"triangle_vertices", list_blobs(s.triangle_vertices)},
          {"triangle_edges", list_blobs(s.triangle_edges)},
          {"labels", blob(labels)},
          {"vertex_attributes", attributes_json(s.vertex_attributes)},
          {"edge_attributes", attributes_json(s.edge_attributes)},
          {"triangle_attributes", attributes_json(s.triangle_attributes)}};
}

SurfaceMesh::State mesh_state_from_json(const json& json_value) {
  const CheckedJson value(json_value, "surface");
  SurfaceMesh::State s;
  s.vertices = pool_from(value.at("vertices"));
  s.edges = pool_from(value.at("edges"));
  s.triangles = pool_from(value.at("triangles"));
  const auto coordinates = from_blob<double>(value.at("positions"));
  if (coordinates.size() % 3 != 0) value.at("positions").refuse("is cut off");
  for (std::size_t i = 0; i < coordinates.size(); i += 3)
    s.positions.emplace_back(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
  from_list_blobs(value.at("vertex_edges"), s.vertex_edges);
  from_list_blobs(value.at("vertex_triangles"), s.vertex_triangles);
  from_list_blobs(value.at("edge_vertices"), s.edge_vertices);
  from_list_blobs(value.at("edge_triangles"), s.edge_triangles);
  from_list_blobs(value.at("triangle_vertices"), s.triangle_vertices);
  from_list_blobs(value.at("triangle_edges"), s.triangle_edges);
  for (const auto& [p, q] : from_blob<std::array<std::uint32_t, 2>>(value.at("labels")))
    s.labels.push_back({Region(p), Region(q)});
  s.vertex_attributes = attributes_from(value.at("vertex_attributes"));
  s.edge_attributes = attributes_from(value.at("edge_attributes"));
  s.triangle_attributes = attributes_from(value.at("triangle_attributes"));
  (void)SurfaceMesh::from_state(s);
  return s;
}

}  // namespace lostopos
