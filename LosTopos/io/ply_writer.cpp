#include <algorithm>

#include "Base/io/atomic_file.h"
#include "LosTopos/io/byte_order.h"
#include "LosTopos/io/ply.h"

namespace lostopos {
namespace {

// The arrays of the data that the format has a place for; null: there is none, or nothing in it.
struct PlyArrays {
  const DataArray* velocity;
  const DataArray* vertex_id;
  const DataArray* solid;

  explicit PlyArrays(const SurfaceData& data)
      : velocity(find_array(data.vertex_arrays, velocity_array)),
        vertex_id(find_array(data.vertex_arrays, vertex_id_array)),
        solid(find_array(data.triangle_arrays, solid_array)) {
    if (velocity != nullptr && velocity->components != 3) velocity = nullptr;
    if (vertex_id != nullptr && !holds_vertex_ids(*vertex_id)) vertex_id = nullptr;
    if (solid != nullptr &&
        (solid->components != 1 || std::ranges::none_of(solid->values, [](double value) { return value != 0; })))
      solid = nullptr;
  }
};

std::string header(const SurfaceData& data, const PlyArrays& arrays) {
  return "ply\n"
         "format binary_little_endian 1.0\n"
         "comment a face's right-hand normal points out of region_a into region_b; region 0 is the open air\n"
         "element vertex " +
         std::to_string(data.positions.size()) +
         "\n"
         "property double x\n"
         "property double y\n"
         "property double z\n" +
         (arrays.velocity != nullptr ? "property double vx\nproperty double vy\nproperty double vz\n" : "") +
         (arrays.vertex_id != nullptr ? "property int vertex_id\n" : "") + "element face " +
         std::to_string(data.triangles.size()) +
         "\n"
         "property list uchar int vertex_indices\n"
         "property int region_a\n"
         "property int region_b\n" +
         (arrays.solid != nullptr ? "property uchar solid\n" : "") + "end_header\n";
}

void append_vertex(std::string& record, const SurfaceData& data, const PlyArrays& arrays, std::size_t v) {
  for (int i = 0; i < 3; ++i) append_bytes(record, data.positions[v][i]);
  if (arrays.velocity != nullptr)
    for (std::size_t i = 0; i < 3; ++i) append_bytes(record, arrays.velocity->values[3 * v + i]);
  if (arrays.vertex_id != nullptr) append_bytes(record, static_cast<std::int32_t>(arrays.vertex_id->values[v]));
}

void append_face(std::string& record, const SurfaceData& data, const PlyArrays& arrays, std::size_t t) {
  append_bytes(record, std::uint8_t{3});
  for (const std::uint32_t corner : data.triangles[t]) append_bytes(record, static_cast<std::int32_t>(corner));
  append_bytes(record, static_cast<std::int32_t>(data.labels[t].p.index()));
  append_bytes(record, static_cast<std::int32_t>(data.labels[t].q.index()));
  if (arrays.solid != nullptr) append_bytes(record, static_cast<std::uint8_t>(arrays.solid->values[t] != 0 ? 1 : 0));
}

}  // namespace

void write_ply(const std::filesystem::path& path, const SurfaceData& data) {
  validate(data);
  base::AtomicFile file(path);
  const PlyArrays arrays(data);
  file.stream() << header(data, arrays);
  std::string record;
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    record.clear();
    append_vertex(record, data, arrays, v);
    file.stream() << record;
  }
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    record.clear();
    append_face(record, data, arrays, t);
    file.stream() << record;
  }
  file.commit();
}

}  // namespace lostopos
