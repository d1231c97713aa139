#include <set>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "LosTopos/io/base64.h"
#include "LosTopos/io/byte_order.h"
#include "LosTopos/io/vtp.h"
#include "LosTopos/io/xml_reader.h"

namespace lostopos {
namespace {

void require_usable_names(const std::vector<DataArray>& arrays, std::set<std::string> taken) {
  for (const DataArray& array : arrays) {
    if (array.name.empty()) throw base::InputError("an array for a .vtp file has no name");
    if (!taken.insert(array.name).second)
      throw base::InputError("array name '" + array.name + "' is taken in a .vtp file; choose another");
  }
}

class VtpWriter {
 public:
  VtpWriter(std::ostream& out, const SurfaceData& data) : out_(out), data_(data) {}

  void write() {
    out_ << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\">\n"
            "<PolyData>\n<Piece NumberOfPoints=\""
         << data_.positions.size() << "\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" NumberOfPolys=\""
         << data_.triangles.size() << "\">\n";
    out_ << "<PointData>\n";
    for (const DataArray& array : data_.vertex_arrays) write_array(array);
    out_ << "</PointData>\n<CellData Scalars=\"region_a\">\n";
    write_labels("region_a", &Labels::p);
    write_labels("region_b", &Labels::q);
    for (const DataArray& array : data_.triangle_arrays) write_array(array);
    out_ << "</CellData>\n<Points>\n";
    start_bytes(data_.positions.size() * 3 * sizeof(double));
    for (const Vec3& position : data_.positions)
      for (int i = 0; i < 3; ++i) append_bytes(bytes_, position[i]);
    write_bytes("Float64", "Points", 3);
    out_ << "</Points>\n<Polys>\n";
    write_polys();
    out_ << "</Polys>\n</Piece>\n</PolyData>\n</VTKFile>\n";
  }

 private:
  void write_array(const DataArray& array) {
    start_bytes(array.values.size() * sizeof(double));
    for (const double value : array.values) append_bytes(bytes_, value);
    write_bytes("Float64", array.name, array.components);
  }

  void write_labels(const char* name, Region Labels::*side) {
    start_bytes(data_.labels.size() * sizeof(std::int32_t));
    for (const Labels& labels : data_.labels) append_bytes(bytes_, static_cast<std::int32_t>((labels.*side).index()));
    write_bytes("Int32", name, 1);
  }

  void write_polys() {
    start_bytes(data_.triangles.size() * 3 * sizeof(std::int64_t));
    for (const auto& corners : data_.triangles)
      for (const std::uint32_t corner : corners) append_bytes(bytes_, static_cast<std::int64_t>(corner));
    write_bytes("Int64", "connectivity", 1);
    start_bytes(data_.triangles.size() * sizeof(std::int64_t));
    for (std::size_t t = 1; t <= data_.triangles.size(); ++t) append_bytes(bytes_, static_cast<std::int64_t>(3 * t));
    write_bytes("Int64", "offsets", 1);
  }

  // An array's bytes start with their number.
  void start_bytes(std::uint64_t count) {
    bytes_.clear();
    bytes_.reserve(count + sizeof(count));
    append_bytes(bytes_, count);
  }

  void write_bytes(const char* type, const std::string& name, int components) {
    out_ << "<DataArray type=\"" << type << "\" Name=\"" << xml_escape(name) << "\" NumberOfComponents=\"" << components
         << "\" format=\"binary\">\n"
         << base64_encode(bytes_) << "\n</DataArray>\n";
  }

  std::ostream& out_;
  const SurfaceData& data_;
  std::string bytes_;
};

}  // namespace

void write_vtp(const std::filesystem::path& path, const SurfaceData& data) {
  validate(data);
  require_usable_names(data.vertex_arrays, {});
  require_usable_names(data.triangle_arrays, {"region_a", "region_b"});
  base::AtomicFile file(path);
  VtpWriter(file.stream(), data).write();
  file.commit();
}

}  // namespace lostopos
