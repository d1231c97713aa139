#include "FoamSim/run/checkpoint.h"

#include <fstream>
#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "Base/options/options_json.h"
#include "LosTopos/error.h"

namespace foamsim {

using lostopos::Region;
using lostopos::SurfaceMesh;
using nlohmann::json;

namespace {

constexpr int version = 4;
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 34;

json volumes_json(const std::vector<lostopos::RegionVolume>& volumes) {
  json list = json::array();
  for (const auto& [region, volume] : volumes) list.push_back({region.index(), volume});
  return list;
}

Checkpoint checkpoint_from(const json& value, std::shared_ptr<const Catalogue> catalogue) {
  if (value.at("format") != "foamsim checkpoint" || value.at("version") != version)
    throw base::InputError("it is not a checkpoint of version " + std::to_string(version));
  const std::string mesh_file = value.at("mesh_file");
  Scene scene = mesh_file.empty() ? built_in_scene(value.at("scene").get<std::string>(), std::move(catalogue))
                                  : mesh_scene(mesh_file, std::move(catalogue));
  base::options_from_json(value.at("options"), scene.options);
  Checkpoint checkpoint{.scene = std::move(scene),
                        .state = simulation_state_from_json(value.at("state")),
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
                   {"resolution", simulation.resolution()},
                   {"start_volumes", volumes_json(start_volumes)},
                   {"start_centroid", {start_centroid.x(), start_centroid.y(), start_centroid.z()}},
                   {"state", to_json(simulation.state())}};
  const std::vector<std::uint8_t> bytes = json::to_cbor(value);
  base::AtomicFile out(file);
  out.stream().write(reinterpret_cast<const char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  out.commit();
}

Checkpoint read_checkpoint(const std::filesystem::path& file, std::shared_ptr<const Catalogue> catalogue) {
  std::error_code error;
  const auto size = std::filesystem::file_size(file, error);
  std::ifstream in(file, std::ios::binary);
  if (error || !in)
    throw base::FileError("cannot read the checkpoint " + file.string() + "; give a run's checkpoint.cbor");
  if (size > most_bytes) throw base::InputError(file.string() + " is too large to be a checkpoint");
  std::vector<std::uint8_t> bytes(size);
  in.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(size));
  try {
    return checkpoint_from(json::from_cbor(bytes), std::move(catalogue));
  } catch (const json::exception& problem) {
    throw base::InputError(file.string() + " is not a whole checkpoint: " + problem.what());
  } catch (const base::Error& problem) {
    throw base::InputError(file.string() + " is not a whole checkpoint: " + problem.what());
  }
}

Simulation resume(const Checkpoint& checkpoint) try {
  Simulation simulation =
      make_simulation(checkpoint.scene, SurfaceMesh::from_state(checkpoint.state.tracker), checkpoint.resolution, {});
  simulation.restore(checkpoint.state);
  return simulation;
} catch (const lostopos::MeshError& problem) {
  throw base::InputError(std::string("it is not a whole checkpoint: ") + problem.what());
}

}  // namespace foamsim
