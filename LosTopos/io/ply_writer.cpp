#include <algorithm>

#include "Base/io/atomic_file.h"
#include "LosTopos/io/byte_order.h"
#include "LosTopos/io/ply.h"

namespace lostopos {
namespace {

// Which triangles belong to solids, where any does; else null.
const DataArray* solids_of(const SurfaceData& data) {
  for (const DataArray& array : data.triangle_arrays)
    if (array.name == "solid" && array.components == 1 &&
        std::ranges::any_of(array.values, [](double value) { return value != 0; }))
      return &array;
  return nullptr;
}

std::string header(const SurfaceData& data, bool with_solids) {
  return "ply\n"
         "format binary_little_endian 1.0\n"
         "comment a face's right-hand normal points out of region_a into region_b; region 0 is the open air\n"
         "element vertex " +
         std::to_string(data.positions.size()) +
         "\n"
         "property double x\n"
         "property double y\n"
         "property double z\n"
         "element face " +
         std::to_string(data.triangles.size()) +
         "\n"
         "property list uchar int vertex_indices\n"
         "property int region_a\n"
         "property int region_b\n" +
         (with_solids ? "property uchar solid\n" : "") + "end_header\n";
}

}  // namespace

void write_ply(const std::filesystem::path& path, const SurfaceData& data) {
  validate(data);
  base::AtomicFile file(path);
  const DataArray* solids = solids_of(data);
  file.stream() << header(data, solids != nullptr);
  std::string record;
  for (const Vec3& position : data.positions) {
    record.clear();
    for (int i = 0; i < 3; ++i) append_bytes(record, position[i]);
    file.stream() << record;
  }
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    record.clear();
    append_bytes(record, std::uint8_t{3});
    for (const std::uint32_t corner : data.triangles[t]) append_bytes(record, static_cast<std::int32_t>(corner));
    append_bytes(record, static_cast<std::int32_t>(data.labels[t].p.index()));
    append_bytes(record, static_cast<std::int32_t>(data.labels[t].q.index()));
    if (solids != nullptr) append_bytes(record, static_cast<std::uint8_t>(solids->values[t] != 0 ? 1 : 0));
    file.stream() << record;
  }
  file.commit();
}

}  // namespace lostopos
