#include "LosTopos/mesh/state_json.h"

#include <cstring>
#include <nlohmann/json.hpp>

#include "LosTopos/error.h"

namespace lostopos {

using nlohmann::json;

namespace {

template <class T>
json blob(const std::vector<T>& values) {
  static_assert(std::is_trivially_copyable_v<T>);
  std::vector<std::uint8_t> bytes(values.size() * sizeof(T));
  if (!bytes.empty()) std::memcpy(bytes.data(), values.data(), bytes.size());
  return json::binary(std::move(bytes));
}

template <class T>
std::vector<T> from_blob(const json& value) {
  const auto& bytes = value.get_binary();
  if (bytes.size() % sizeof(T) != 0) throw base::InputError("an array is cut off");
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

template <class Lists>
void from_list_blobs(const json& value, Lists& lists) {
  using List = typename Lists::value_type;
  const auto lengths = from_blob<std::uint32_t>(value.at(0)), elements = from_blob<std::uint32_t>(value.at(1));
  std::size_t next = 0;
  for (std::uint32_t length : lengths) {
    if (length > elements.size() - next) throw base::InputError("a list of elements is cut off");
    List list{};
    for (std::uint32_t i = 0; i < length; ++i) {
      const typename List::value_type element(elements[next++]);
      if constexpr (requires { list.push_back(element); })
        list.push_back(element);
      else
        list.at(i) = element;
    }
    lists.push_back(std::move(list));
  }
}

json pool_json(const SlotPool& pool) {
  return {blob(pool.alive()), blob(pool.free())};
}

SlotPool pool_from(const json& value) {
  auto alive = from_blob<char>(value.at(0));
  auto free = from_blob<std::uint32_t>(value.at(1));
  for (std::uint32_t slot : free)
    if (slot >= alive.size() || alive[slot]) throw base::InputError("a free slot is in use");
  return {std::move(alive), std::move(free)};
}

json attributes_json(const std::vector<StoredAttribute>& attributes) {
  json by_name = json::object();
  for (const auto& [name, values] : attributes)
    by_name[name] = {{"type", values->type()}, {"count", values->size()}, {"bytes", json::binary(values->encoded())}};
  return by_name;
}

std::vector<StoredAttribute> attributes_from(const json& by_name) {
  std::vector<StoredAttribute> attributes;
  for (const auto& [name, value] : by_name.items()) {
    const std::vector<std::uint8_t>& bytes = value.at("bytes").get_binary();
    attributes.emplace_back(
        name, std::make_unique<EncodedValues>(value.at("type"), value.at("count").get<std::size_t>(), bytes));
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

SurfaceMesh::State mesh_state_from_json(const json& value) {
  SurfaceMesh::State s;
  s.vertices = pool_from(value.at("vertices"));
  s.edges = pool_from(value.at("edges"));
  s.triangles = pool_from(value.at("triangles"));
  const auto coordinates = from_blob<double>(value.at("positions"));
  if (coordinates.size() % 3 != 0) throw base::InputError("a position is cut off");
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
  require_consistent(s);
  return s;
}

}  // namespace lostopos
