#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "Base/error.h"
#include "Base/io/number_text.h"
#include "LosTopos/io/byte_reader.h"
#include "LosTopos/io/read_error.h"
#include "LosTopos/io/surface_checks.h"
#include "LosTopos/io/vtk_array.h"
#include "LosTopos/io/vtk_surface.h"

namespace lostopos {
namespace {

using Event = XmlReader::Event;

struct PlacedArray {
  DataArray data;
  std::size_t line;  // where it ends in the file
};

// The first piece of the file as it stands; whether it makes a surface is the next question.
struct Piece {
  std::uint64_t vertices = 0, lines = 0, triangles = 0;
  std::vector<PlacedArray> points, line_cells, polys, point_data, cell_data;
};

std::string line_count_problem(std::uint64_t lines) {
  return lines <= most_triangles ? "" : "there are " + std::to_string(lines) + " lines, more than can be read";
}

class PieceReader {
 public:
  /// `type`: PolyData or UnstructuredGrid.
  PieceReader(std::string_view text, const std::string& name, const char* type) : xml_(text, name), type_(type) {}

  Piece read() {
    require_start("VTKFile");
    encoding_ = read_vtk_root(xml_, type_);
    require_start(type_);
    bool has_piece = false;
    while (xml_.next() == Event::Start) {  // ends with the element of the type, or throws
      if (xml_.tag() == "Piece" && has_piece) xml_.fail("a second piece; files with one are read");
      if (xml_.tag() == "Piece") {
        has_piece = true;
        read_piece();
      } else {
        xml_.skip_element();
      }
    }
    if (!has_piece) xml_.fail("no element 'Piece' in the file");
    while (xml_.next() != Event::Finished) {  // ends: every turn passes a tag
    }
    return std::move(piece_);
  }

 private:
  void require_start(const char* tag) {
    if (xml_.next() != Event::Start || xml_.tag() != tag)
      xml_.fail(in_quotes(xml_.tag()) + " stands where the element '" + tag + "' should");
  }

  std::uint64_t count(const char* key, const char* fallback) {
    const std::string text = xml_.attribute(key, fallback);
    const auto value = base::parse_integer(text);
    if (!value || *value < 0)
      xml_.fail(std::string(key) + " is " + in_quotes(text) + "; a whole number would be right");
    return static_cast<std::uint64_t>(*value);
  }

  void read_piece() {
    piece_.vertices = count("NumberOfPoints", "");
    piece_.triangles = count("NumberOfPolys", "0");
    piece_.lines = count("NumberOfLines", "0");
    cell_count_ = count("NumberOfCells", "0");
    for (const std::string& problem : {vertex_count_problem(piece_.vertices), triangle_count_problem(piece_.triangles),
                                       line_count_problem(piece_.lines)})
      if (!problem.empty()) xml_.fail(problem);
    for (const char* other : {"NumberOfVerts", "NumberOfStrips"})
      if (count(other, "0") != 0) xml_.fail(std::string(other) + " is not 0; only lines and polygons are read");
    while (xml_.next() == Event::Start) {  // ends with the piece, or throws
      if (xml_.tag() == "PointData") {
        read_arrays(piece_.point_data);
      } else if (xml_.tag() == "CellData") {
        read_arrays(piece_.cell_data);
      } else if (xml_.tag() == "Points") {
        read_arrays(piece_.points);
      } else if (xml_.tag() == "Lines") {
        read_arrays(piece_.line_cells);
      } else if (xml_.tag() == "Polys") {
        read_arrays(piece_.polys);
      } else if (xml_.tag() == "Cells") {
        read_arrays(cells_);
      } else {
        xml_.skip_element();
      }
    }
    if (cell_count_ > 0) split_cells();
  }

  // Of an unstructured grid: lines, and triangles behind them, as poly data has them.
  void split_cells() {
    PlacedArray ids = cell_array("connectivity"), offsets = cell_array("offsets");
    const PlacedArray types = cell_array("types");
    require_one_a_cell(offsets);
    require_one_a_cell(types);
    const auto& type = types.data.values;
    const auto first_triangle = std::ranges::find_if(type, [](double t) { return t != vtk_line; });
    const auto other = std::find_if(first_triangle, type.end(), [](double t) { return t != vtk_triangle; });
    if (other != type.end()) {
      std::string problem = "cell " + std::to_string(other - type.begin()) + " is of type ";
      base::append_number(problem, *other);
      fail_at(types, problem + "; lines (3), and triangles (5) behind them, are read");
    }
    piece_.lines = static_cast<std::uint64_t>(first_triangle - type.begin());
    piece_.triangles = cell_count_ - piece_.lines;
    const std::uint64_t line_ends = 2 * piece_.lines;
    if (ids.data.values.size() != line_ends + 3 * piece_.triangles)
      fail_at(ids, "its length does not fit lines of two points and triangles of three");
    piece_.line_cells = {first_part(ids, line_ends), first_part(offsets, piece_.lines)};
    for (double& offset : offsets.data.values) offset -= static_cast<double>(line_ends);
    piece_.polys = {std::move(ids), std::move(offsets)};
  }

  void require_one_a_cell(const PlacedArray& array) const {
    const std::size_t size = array.data.values.size();
    if (size != cell_count_)
      fail_at(array, std::to_string(size) + " numbers for " + std::to_string(cell_count_) + " cells");
  }

  PlacedArray cell_array(std::string_view name) const {
    const auto found = std::ranges::find(cells_, name, [](const PlacedArray& array) { return array.data.name; });
    if (found == cells_.end()) xml_.fail("section 'Cells' needs the array " + in_quotes(name));
    return *found;
  }

  // Takes its first numbers away from it.
  static PlacedArray first_part(PlacedArray& array, std::uint64_t count) {
    auto& values = array.data.values;
    const auto end = values.begin() + static_cast<std::ptrdiff_t>(count);
    PlacedArray part = {{array.data.name, array.data.components, {values.begin(), end}}, array.line};
    values.erase(values.begin(), end);
    return part;
  }

  [[noreturn]] void fail_at(const PlacedArray& array, const std::string& problem) const {
    throw_at_line(xml_.name(), array.line, "array " + in_quotes(array.data.name) + ": " + problem);
  }

  void read_arrays(std::vector<PlacedArray>& arrays) {
    while (xml_.next() == Event::Start) {  // ends with the section, or throws
      if (xml_.tag() == "DataArray") {
        arrays.push_back({read_vtk_array(xml_, encoding_), xml_.line()});
      } else {
        xml_.skip_element();  // an array of text
      }
    }
  }

  XmlReader xml_;
  const char* type_;
  VtkEncoding encoding_;
  std::uint64_t cell_count_ = 0;
  std::vector<PlacedArray> cells_;
  Piece piece_;
};

class SurfaceAssembler {
 public:
  SurfaceAssembler(Piece piece, std::string name) : piece_(std::move(piece)), name_(std::move(name)) {}

  SurfaceData assemble() {
    if (piece_.vertices > 0) assemble_points();
    if (piece_.triangles > 0) assemble_triangles();
    assemble_lines();
    drop_values_of_lines();
    assemble_labels();
    move_arrays(piece_.point_data, piece_.vertices, data_.vertex_arrays);
    move_arrays(piece_.cell_data, piece_.triangles, data_.triangle_arrays);
    require_edges_in_range(data_, name_);
    return std::move(data_);
  }

 private:
  [[noreturn]] void fail(const PlacedArray& array, const std::string& problem) const {
    throw_at_line(name_, array.line, "array " + in_quotes(array.data.name) + ": " + problem);
  }

  void require_length(const PlacedArray& array, std::uint64_t elements, std::uint64_t components) const {
    const std::uint64_t size = array.data.values.size();
    if (size / components != elements || size % components != 0)
      fail(array, std::to_string(size) + " numbers; " + std::to_string(elements) + " times " +
                      std::to_string(components) + " are wanted");
  }

  // Takes the array out of the list after a look at its length.
  std::optional<PlacedArray> take(std::vector<PlacedArray>& arrays, std::string_view name, std::uint64_t components) {
    const auto found = std::ranges::find_if(arrays, [&](const PlacedArray& array) { return array.data.name == name; });
    if (found == arrays.end()) return std::nullopt;
    require_length(*found, piece_.triangles, components);
    PlacedArray array = std::move(*found);
    arrays.erase(found);
    return array;
  }

  void assemble_points() {
    if (piece_.points.size() != 1)
      throw base::InputError(name_ + ": section 'Points' has " + std::to_string(piece_.points.size()) +
                             " arrays, not 1");
    const PlacedArray& points = piece_.points[0];
    require_length(points, piece_.vertices, 3);
    data_.positions.reserve(piece_.vertices);
    for (std::size_t v = 0; v < piece_.vertices; ++v) {
      const double* x = points.data.values.data() + 3 * v;
      data_.positions.emplace_back(x[0], x[1], x[2]);
      reject(points, position_problem(data_.positions.back()), "point", v);
    }
  }

  void assemble_triangles() {
    const auto offsets = take(piece_.polys, "offsets", 1);
    const auto ids = offsets ? take_connectivity(*offsets) : std::nullopt;
    if (!ids) throw base::InputError(name_ + ": section 'Polys' needs the arrays 'connectivity' and 'offsets'");
    data_.triangles.reserve(piece_.triangles);
    for (std::size_t t = 0; t < piece_.triangles; ++t) {
      std::array<std::int64_t, 3> corners{};
      for (std::size_t i = 0; i < 3; ++i) corners[i] = whole(*ids, 3 * t + i);
      reject(*ids, corner_problem(corners, piece_.vertices), "polygon", t);
      data_.triangles.push_back(checked_corners(corners));
    }
  }

  // Lines of two ends each; longer ones, which other programs write, are left out.
  void assemble_lines() {
    const auto offsets =
        std::ranges::find_if(piece_.line_cells, [](const PlacedArray& array) { return array.data.name == "offsets"; });
    const auto ids = std::ranges::find_if(piece_.line_cells,
                                          [](const PlacedArray& array) { return array.data.name == "connectivity"; });
    if (piece_.lines == 0 || offsets == piece_.line_cells.end() || ids == piece_.line_cells.end()) return;
    require_length(*offsets, piece_.lines, 1);
    std::int64_t begin = 0;
    for (std::size_t i = 0; i < piece_.lines; ++i) {
      const std::int64_t end = whole(*offsets, i);
      if (end < begin || static_cast<std::uint64_t>(end) > ids->data.values.size())
        fail(*offsets, "line " + std::to_string(i) + " ends outside of 'connectivity'");
      if (end - begin == 2) data_.lines.push_back(line_at(*ids, static_cast<std::size_t>(begin)));
      begin = end;
    }
  }

  std::array<std::uint32_t, 2> line_at(const PlacedArray& ids, std::size_t begin) const {
    std::array<std::uint32_t, 2> line{};
    for (std::size_t i = 0; i < 2; ++i) {
      const std::int64_t end = whole(ids, begin + i);
      if (end < 0 || static_cast<std::uint64_t>(end) >= piece_.vertices)
        fail(ids, "a line names vertex " + std::to_string(end) + ", which does not exist");
      line[i] = static_cast<std::uint32_t>(end);
    }
    return line;
  }

  // Lines come before polygons among the cells; what cells' arrays say of them is not kept.
  void drop_values_of_lines() {
    if (piece_.lines == 0) return;
    for (PlacedArray& array : piece_.cell_data) {
      const auto components = static_cast<std::uint64_t>(array.data.components);
      require_length(array, piece_.lines + piece_.triangles, components);
      const auto end = array.data.values.begin() + static_cast<std::ptrdiff_t>(piece_.lines * components);
      array.data.values.erase(array.data.values.begin(), end);
    }
  }

  std::optional<PlacedArray> take_connectivity(const PlacedArray& offsets) {
    for (std::size_t t = 0; t < piece_.triangles; ++t)
      if (offsets.data.values[t] != 3.0 * static_cast<double>(t + 1))
        fail(offsets, "polygon " + std::to_string(t) + " is no triangle; triangulate the surface first");
    return take(piece_.polys, "connectivity", 3);
  }

  void assemble_labels() {
    const auto p = take(piece_.cell_data, "region_a", 1), q = take(piece_.cell_data, "region_b", 1);
    if (p.has_value() != q.has_value())
      fail(p ? *p : *q, std::string(p ? "region_b" : "region_a") + " is missing; both or neither would be right");
    data_.labels.assign(piece_.triangles, default_labels);
    for (std::size_t t = 0; p && t < piece_.triangles; ++t) {
      const std::int64_t a = whole(*p, t), b = whole(*q, t);
      reject(*q, label_problem(a, b), "polygon", t);
      data_.labels[t] = checked_labels(a, b);
    }
  }

  void move_arrays(std::vector<PlacedArray>& from, std::uint64_t elements, std::vector<DataArray>& to) {
    std::set<std::string> taken;
    for (PlacedArray& array : from) {
      require_length(array, elements, static_cast<std::uint64_t>(array.data.components));
      if (array.data.name.empty()) fail(array, "it has no name");
      if (!taken.insert(array.data.name).second) fail(array, "the name is taken");
      to.push_back(std::move(array.data));
    }
  }

  std::int64_t whole(const PlacedArray& array, std::size_t place) const {
    const double value = array.data.values[place];
    constexpr double largest = 9007199254740992.0;  // 2^53: up to here doubles hold all whole numbers
    if (!(std::abs(value) < largest) || value != std::floor(value))
      fail(array, "number " + std::to_string(place) + " should be whole");
    return static_cast<std::int64_t>(value);
  }

  void reject(const PlacedArray& array, const std::string& problem, const char* element, std::uint64_t number) const {
    if (!problem.empty()) fail(array, std::string(element) + " " + std::to_string(number) + ": " + problem);
  }

  Piece piece_;
  std::string name_;
  SurfaceData data_;
};

SurfaceData read(const std::filesystem::path& path, const char* type) {
  ByteReader bytes(path);
  const std::string text = bytes.read_text();
  return SurfaceAssembler(PieceReader(text, bytes.name(), type).read(), bytes.name()).assemble();
}

}  // namespace

SurfaceData read_vtp(const std::filesystem::path& path) {
  return read(path, "PolyData");
}

SurfaceData read_vtu(const std::filesystem::path& path) {
  return read(path, "UnstructuredGrid");
}

}  // namespace lostopos
