#include "FoamSim/run/checkpoint.h"

#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/options/options_json.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using lostopos::Vertex;
using nlohmann::json;

namespace {

constexpr int version = 2;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 34;

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

json pool_json(const lostopos::SlotPool& pool) {
  return {blob(pool.alive()), blob(pool.free())};
}

lostopos::SlotPool pool_from(const json& value) {
  auto alive = from_blob<char>(value.at(0));
  auto free = from_blob<std::uint32_t>(value.at(1));
  for (std::uint32_t slot : free)
    if (slot >= alive.size() || alive[slot]) throw base::InputError("a free slot is in use");
  return {std::move(alive), std::move(free)};
}

json mesh_json(const SurfaceMesh& mesh) {
  const SurfaceMesh::State s = mesh.state();
  std::vector<std::array<std::uint32_t, 2>> labels;
  for (const lostopos::Labels& pq : s.labels) labels.push_back({pq.p.index(), pq.q.index()});
  std::vector<double> coordinates;
  for (const lostopos::Vec3& x : s.positions) coordinates.insert(coordinates.end(), x.begin(), x.end());
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
          {"labels", blob(labels)}};
}

SurfaceMesh mesh_from(const json& value) {
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
  return SurfaceMesh::from_state(s);
}

struct StoredValue {
  std::uint32_t low, high;
  double value;
};

json circulation_json(const SurfaceMesh& mesh, const CirculationField& circulation) {
  std::vector<std::uint32_t> counts(mesh.vertex_slots(), 0);
  std::vector<StoredValue> values;
  for (Vertex v : mesh.vertices())
    for (const PairCirculation& held : circulation.at(v)) {
      ++counts[v.index()];
      values.push_back({held.pair.low.index(), held.pair.high.index(), held.value});
    }
  return {blob(counts), blob(values)};
}

std::vector<std::vector<PairCirculation>> circulation_from(const json& value) {
  const auto counts = from_blob<std::uint32_t>(value.at(0));
  const auto values = from_blob<StoredValue>(value.at(1));
  std::vector<std::vector<PairCirculation>> circulation(counts.size());
  std::size_t next = 0;
  for (std::size_t v = 0; v < counts.size(); ++v)
    for (std::uint32_t i = 0; i < counts[v]; ++i) {
      if (next >= values.size()) throw base::InputError("circulation is cut off");
      const StoredValue& stored = values[next++];
      circulation[v].push_back({RegionPair(Region(stored.low), Region(stored.high)), stored.value});
    }
  return circulation;
}

json held_json(const Simulation& simulation) {
  std::vector<std::uint32_t> held;
  const auto slots = simulation.held();
  for (std::size_t i = 0; i < slots.size(); ++i)
    if (slots[i] != 0 && simulation.mesh().alive(Vertex(i))) held.push_back(Vertex(i).index());
  return blob(held);
}

std::vector<Vertex> held_from(const json& value, const SurfaceMesh& mesh) {
  std::vector<Vertex> held;
  for (std::uint32_t slot : from_blob<std::uint32_t>(value)) {
    if (slot >= mesh.vertex_slots() || !mesh.alive(Vertex(slot)))
      throw base::InputError("a held vertex does not exist");
    held.emplace_back(slot);
  }
  return held;
}

json topology_json(const TopologyTotals& t) {
  return {t.snaps, t.edge_merges, t.separations, t.region_collapses, t.cancelled_triangles};
}

TopologyTotals topology_from(const json& value) {
  const auto counts = value.get<std::array<std::size_t, 5>>();
  return {counts[0], counts[1], counts[2], counts[3], counts[4]};
}

json volumes_json(const std::vector<lostopos::RegionVolume>& volumes) {
  json list = json::array();
  for (const auto& [region, volume] : volumes) list.push_back({region.index(), volume});
  return list;
}

Checkpoint checkpoint_from(const json& value) {
  if (value.at("format") != "foamsim checkpoint" || value.at("version") != version)
    throw base::InputError("it is not a checkpoint of version " + std::to_string(version));
  Scene scene{value.at("scene"), value.at("mesh_file"), base::OptionSet(scene_option_specs()), {}};
  base::options_from_json(value.at("options"), scene.options);
  SurfaceMesh mesh = mesh_from(value.at("mesh"));
  std::vector<Vertex> held = held_from(value.at("held"), mesh);
  Checkpoint checkpoint{.scene = std::move(scene),
                        .mesh = std::move(mesh),
                        .circulation = circulation_from(value.at("circulation")),
                        .held = std::move(held),
                        .step = value.at("step"),
                        .topology = topology_from(value.at("topology")),
                        .resolution = value.at("resolution"),
                        .start_volumes = {},
                        .start_centroid = lostopos::Vec3::Zero()};
  if (checkpoint.circulation.size() != checkpoint.mesh.vertex_slots())
    throw base::InputError("circulation and mesh differ in length");
  for (const json& entry : value.at("start_volumes"))
    checkpoint.start_volumes.push_back({Region(entry.at(0).get<std::uint32_t>()), entry.at(1)});
  const auto centroid = value.at("start_centroid").get<std::array<double, 3>>();
  checkpoint.start_centroid = {centroid[0], centroid[1], centroid[2]};
  return checkpoint;
}

}  // namespace

void write_checkpoint(const std::filesystem::path& file, const Scene& scene, const Simulation& simulation,
                      const std::vector<lostopos::RegionVolume>& start_volumes, const lostopos::Vec3& start_centroid) {
  const json value{{"format", "foamsim checkpoint"},
                   {"version", version},
                   {"scene", scene.name},
                   {"mesh_file", scene.mesh_file},
                   {"options", base::options_to_json(scene.options)},
                   {"step", simulation.steps()},
                   {"topology", topology_json(simulation.topology_totals())},
                   {"resolution", simulation.resolution()},
                   {"start_volumes", volumes_json(start_volumes)},
                   {"start_centroid", {start_centroid.x(), start_centroid.y(), start_centroid.z()}},
                   {"mesh", mesh_json(simulation.mesh())},
                   {"held", held_json(simulation)},
                   {"circulation", circulation_json(simulation.mesh(), simulation.circulation())}};
  const std::vector<std::uint8_t> bytes = json::to_cbor(value);
  base::AtomicFile out(file);
  out.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.commit();
}

Checkpoint read_checkpoint(const std::filesystem::path& file) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in)
    throw base::FileError("cannot read the checkpoint " + file.string() + "; give a run's checkpoint.cbor");
  if (size > most_bytes) throw base::InputError(file.string() + " is too large to be a checkpoint");
  std::vector<std::uint8_t> bytes(size);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  try {
    return checkpoint_from(json::from_cbor(bytes));
  } catch (const json::exception& problem) {
    throw base::InputError(file.string() + " is not a whole checkpoint: " + problem.what());
  } catch (const base::Error& problem) {
    throw base::InputError(file.string() + " is not a whole checkpoint: " + problem.what());
  }
}

Simulation resume(Checkpoint& checkpoint) {
  Simulation simulation =
      make_simulation(checkpoint.scene, std::move(checkpoint.mesh), checkpoint.resolution, checkpoint.held);
  for (std::size_t slot = 0; slot < checkpoint.circulation.size(); ++slot)
    for (const PairCirculation& held : checkpoint.circulation[slot])
      simulation.circulation().set(Vertex(slot), {held.pair.low, held.pair.high}, held.value);
  simulation.set_steps(checkpoint.step);
  simulation.set_topology_totals(checkpoint.topology);
  return simulation;
}

}  // namespace foamsim
