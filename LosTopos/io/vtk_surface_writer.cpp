#include <limits>
#include <set>

#include "Base/error.h"
#include "Base/io/atomic_file.h"
#include "LosTopos/io/byte_order.h"
#include "LosTopos/io/vtk_array.h"
#include "LosTopos/io/vtk_compression.h"
#include "LosTopos/io/vtk_surface.h"
#include "LosTopos/io/xml_reader.h"

namespace lostopos {
namespace {

void require_usable_names(const std::vector<DataArray>& arrays, std::set<std::string> taken) {
  for (const DataArray& array : arrays) {
    if (array.name.empty()) throw base::InputError("an array for a VTK file has no name");
    if (!taken.insert(array.name).second)
      throw base::InputError("array name '" + array.name + "' is taken in a VTK file; choose another");
  }
}

class VtkWriter {
 public:
  VtkWriter(std::ostream& out, const SurfaceData& data) : out_(out), data_(data) {}

  void write_poly_data() {
    begin("PolyData");
    out_ << " NumberOfVerts=\"0\" NumberOfLines=\"" << data_.lines.size() << "\" NumberOfStrips=\"0\" NumberOfPolys=\""
         << data_.triangles.size() << "\">\n";
    write_fields_and_points();
    out_ << "<Lines>\n";
    write_connectivity({&data_.lines, nullptr});
    write_offsets(data_.lines.size(), 0);
    out_ << "</Lines>\n<Polys>\n";
    write_connectivity({nullptr, &data_.triangles});
    write_offsets(0, data_.triangles.size());
    out_ << "</Polys>\n";
    end("PolyData");
  }

  void write_unstructured_grid() {
    begin("UnstructuredGrid");
    out_ << " NumberOfCells=\"" << data_.lines.size() + data_.triangles.size() << "\">\n";
    write_fields_and_points();
    out_ << "<Cells>\n";
    write_connectivity({&data_.lines, &data_.triangles});
    write_offsets(data_.lines.size(), data_.triangles.size());
    bytes_.assign(data_.lines.size(), static_cast<char>(vtk_line));
    bytes_.append(data_.triangles.size(), static_cast<char>(vtk_triangle));
    write_bytes("UInt8", "types", 1, {});
    out_ << "</Cells>\n";
    end("UnstructuredGrid");
  }

 private:
  struct Cells {
    const std::vector<std::array<std::uint32_t, 2>>* lines;
    const std::vector<std::array<std::uint32_t, 3>>* triangles;
  };

  // Up to the number of points.
  void begin(const char* type) {
    out_ << "<?xml version=\"1.0\"?>\n"
            "<VTKFile type=\""
         << type
         << "\" version=\"1.0\" byte_order=\"LittleEndian\" header_type=\"UInt64\" "
            "compressor=\"vtkZLibDataCompressor\">\n<"
         << type << ">\n<Piece NumberOfPoints=\"" << data_.positions.size() << "\"";
  }

  void end(const char* type) { out_ << "</Piece>\n</" << type << ">\n</VTKFile>\n"; }

  void write_fields_and_points() {
    out_ << "<PointData>\n";
    for (const DataArray& array : data_.vertex_arrays) write_array(array, 0);
    out_ << "</PointData>\n<CellData Scalars=\"region_a\">\n";
    write_labels("region_a", &Labels::p);
    write_labels("region_b", &Labels::q);
    for (const DataArray& array : data_.triangle_arrays) write_array(array, data_.lines.size());
    out_ << "</CellData>\n<Points>\n";
    start_bytes(data_.positions.size() * 3 * sizeof(double));
    for (const Vec3& position : data_.positions)
      for (int i = 0; i < 3; ++i) append_bytes(bytes_, position[i]);
    write_bytes("Float64", "Points", 3, "L");
    out_ << "</Points>\n";
  }

  // Lines come before triangles among the cells, and have no values.
  void write_array(const DataArray& array, std::size_t lines) {
    const std::size_t without = lines * static_cast<std::size_t>(array.components);
    start_bytes((without + array.values.size()) * sizeof(double));
    for (std::size_t i = 0; i < without; ++i) append_bytes(bytes_, std::numeric_limits<double>::quiet_NaN());
    for (const double value : array.values) append_bytes(bytes_, value);
    write_bytes("Float64", array.name, array.components, array.unit);
  }

  void write_labels(const char* name, Region Labels::*side) {
    start_bytes((data_.lines.size() + data_.labels.size()) * sizeof(std::int32_t));
    for (std::size_t i = 0; i < data_.lines.size(); ++i) append_bytes(bytes_, std::int32_t{-1});
    for (const Labels& labels : data_.labels) append_bytes(bytes_, static_cast<std::int32_t>((labels.*side).index()));
    write_bytes("Int32", name, 1, {});
  }

  void write_connectivity(const Cells& cells) {
    bytes_.clear();
    const auto append = [this](const auto* several) {
      if (several == nullptr) return;
      for (const auto& corners : *several)
        for (const std::uint32_t corner : corners) append_bytes(bytes_, static_cast<std::int64_t>(corner));
    };
    append(cells.lines);
    append(cells.triangles);
    write_bytes("Int64", "connectivity", 1, {});
  }

  void write_offsets(std::size_t lines, std::size_t triangles) {
    start_bytes((lines + triangles) * sizeof(std::int64_t));
    for (std::size_t i = 1; i <= lines; ++i) append_bytes(bytes_, static_cast<std::int64_t>(2 * i));
    for (std::size_t i = 1; i <= triangles; ++i) append_bytes(bytes_, static_cast<std::int64_t>(2 * lines + 3 * i));
    write_bytes("Int64", "offsets", 1, {});
  }

  void start_bytes(std::size_t count) {
    bytes_.clear();
    bytes_.reserve(count);
  }

  void write_bytes(const char* type, const std::string& name, int components, const std::string& unit) {
    out_ << "<DataArray type=\"" << type << "\" Name=\"" << xml_escape(name) << "\" NumberOfComponents=\"" << components
         << "\" format=\"binary\">\n"
         << vtk_compress(bytes_) << "\n";
    if (!unit.empty())
      out_ << "<InformationKey name=\"UNITS_LABEL\" location=\"vtkDataArray\">" << xml_escape(unit)
           << "</InformationKey>\n";
    out_ << "</DataArray>\n";
  }

  std::ostream& out_;
  const SurfaceData& data_;
  std::string bytes_;
};

void write(const std::filesystem::path& path, const SurfaceData& data, void (VtkWriter::*write_as)()) {
  validate(data);
  require_usable_names(data.vertex_arrays, {});
  require_usable_names(data.triangle_arrays, {"region_a", "region_b"});
  base::AtomicFile file(path);
  VtkWriter writer(file.stream(), data);
  (writer.*write_as)();
  file.commit();
}

}  // namespace

void write_vtp(const std::filesystem::path& path, const SurfaceData& data) {
  write(path, data, &VtkWriter::write_poly_data);
}

void write_vtu(const std::filesystem::path& path, const SurfaceData& data) {
  write(path, data, &VtkWriter::write_unstructured_grid);
}

}  // namespace lostopos
