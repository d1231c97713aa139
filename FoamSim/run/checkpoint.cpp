#include "FoamSim/run/checkpoint.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/options/options_json.h"
#include "LosTopos/error.h"
#include "LosTopos/mesh/state_json.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using nlohmann::json;

namespace {

constexpr int version = 3;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 34;

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
  Checkpoint checkpoint{.scene = std::move(scene),
                        .mesh = SurfaceMesh::from_state(lostopos::mesh_state_from_json(value.at("mesh"))),
                        .step = value.at("step"),
                        .topology = topology_from(value.at("topology")),
                        .resolution = value.at("resolution"),
                        .start_volumes = {},
                        .start_centroid = lostopos::Vec3::Zero()};
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
                   {"mesh", lostopos::to_json(simulation.mesh().state())}};
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

Simulation resume(Checkpoint& checkpoint) try {
  // The attributes of the checkpoint wait in the mesh for those of the simulation.
  Simulation simulation = make_simulation(checkpoint.scene, std::move(checkpoint.mesh), checkpoint.resolution, {});
  simulation.set_steps(checkpoint.step);
  simulation.set_topology_totals(checkpoint.topology);
  return simulation;
} catch (const lostopos::MeshError& problem) {
  throw base::InputError(std::string("it is not a whole checkpoint: ") + problem.what());
}

}  // namespace foamsim
