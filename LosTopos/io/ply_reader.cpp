#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "LosTopos/io/ply.h"
#include "LosTopos/io/ply_header.h"
#include "LosTopos/io/ply_values.h"
#include "LosTopos/io/surface_checks.h"

namespace lostopos {
namespace {

class PlyReader {
 public:
  PlyReader(const PlyHeader& header, PlyValues& values) : header_(header), values_(values) {}

  SurfaceData read() {
    const PlyElement& vertices = required_element("vertex");
    const PlyElement& faces = required_element("face");
    reject(vertex_count_problem(vertices.count));
    reject(triangle_count_problem(faces.count));
    for (const PlyElement& element : header_.elements) {
      if (element.count == 0) continue;
      values_.require_room(element);
      if (&element == &vertices) {
        read_vertices(element);
      } else if (&element == &faces) {
        read_faces(element, vertices.count);
      } else if (!element.properties.empty()) {  // records without properties take no room, however many there are
        skip(element);
      }
    }
    values_.begin_record();
    values_.require_end();
    return std::move(data_);
  }

 private:
  const PlyElement& required_element(const char* name) {
    for (const PlyElement& element : header_.elements)
      if (element.name == name) return element;
    values_.fail(std::string("the header has no element '") + name + "'; a surface needs 'vertex' and 'face'");
  }

  // Place of a scalar property.
  std::optional<std::size_t> scalar(const PlyElement& element, std::string_view name) {
    const auto place = element.find({name});
    if (place && element.properties[*place].is_list())
      values_.fail("property '" + std::string(name) + "' is a list; a single number would be right");
    return place;
  }

  // Where each property of a vertex goes: 0 to 2 position, 3 to 5 velocity, 6 its lasting number, 7 nowhere.
  std::vector<std::size_t> vertex_places(const PlyElement& element) {
    static constexpr std::array<std::string_view, nowhere> names{"x", "y", "z", "vx", "vy", "vz", vertex_id_array};
    std::array<std::optional<std::size_t>, nowhere> found;
    for (std::size_t i = 0; i < nowhere; ++i) found[i] = scalar(element, names[i]);
    for (std::size_t i = 0; i < 3; ++i)
      if (!found[i]) values_.fail("element 'vertex' has no property '" + std::string(names[i]) + "'");
    if (!found[3] || !found[4] || !found[5]) found[3] = found[4] = found[5] = std::nullopt;
    std::vector<std::size_t> places(element.properties.size(), nowhere);
    for (std::size_t i = 0; i < nowhere; ++i)
      if (found[i]) places[*found[i]] = i;
    if (found[3]) data_.vertex_arrays.push_back({velocity_array, 3, {}, "L/T"});
    if (found[6]) data_.vertex_arrays.push_back({vertex_id_array, 1, {}});
    return places;
  }

  void read_vertices(const PlyElement& element) {
    const std::vector<std::size_t> places = vertex_places(element);
    data_.positions.reserve(element.count);
    for (std::uint64_t v = 0; v < element.count; ++v) {
      values_.begin_record();
      std::array<double, nowhere> numbers{};
      for (std::size_t i = 0; i < places.size(); ++i) {
        if (places[i] < nowhere)
          numbers.at(places[i]) = values_.next(element.properties[i].type);
        else
          values_.skip_property(element.properties[i]);
      }
      const Vec3 position(numbers[0], numbers[1], numbers[2]);
      reject(position_problem(position), "vertex", v);
      data_.positions.push_back(position);
      for (DataArray& array : data_.vertex_arrays) {
        const double* first = array.components == 3 ? &numbers[3] : &numbers[6];
        array.values.insert(array.values.end(), first, first + array.components);
      }
    }
  }

  void read_faces(const PlyElement& element, std::uint64_t vertex_count) {
    const auto list = element.find({"vertex_indices", "vertex_index"});
    if (!list || !element.properties[*list].is_list())
      values_.fail("element 'face' has no list 'vertex_indices'; 'property list uchar int vertex_indices' is wanted");
    const auto region_a = scalar(element, "region_a"), region_b = scalar(element, "region_b");
    if (region_a.has_value() != region_b.has_value())
      values_.fail(std::string("element 'face' has '") + (region_a ? "region_a" : "region_b") + "' without '" +
                   (region_a ? "region_b" : "region_a") + "'; both or neither would be right");
    const auto solid = scalar(element, solid_array);
    if (solid) data_.triangle_arrays.push_back({solid_array, 1, {}});
    data_.triangles.reserve(element.count);
    data_.labels.reserve(element.count);
    for (std::uint64_t t = 0; t < element.count; ++t) {
      values_.begin_record();
      std::array<std::int64_t, 3> corners{};
      std::int64_t p = default_labels.p.index(), q = default_labels.q.index();
      for (std::size_t place = 0; place < element.properties.size(); ++place) {
        const PlyProperty& property = element.properties[place];
        if (place == *list) {
          corners = read_corners(property, t);
        } else if (place == region_a) {
          p = values_.next_integer(property.type, "region_a");
        } else if (place == region_b) {
          q = values_.next_integer(property.type, "region_b");
        } else if (place == solid) {
          data_.triangle_arrays.back().values.push_back(values_.next(property.type));
        } else {
          values_.skip_property(property);
        }
      }
      reject(corner_problem(corners, vertex_count), "face", t);
      reject(label_problem(p, q), "face", t);
      data_.triangles.push_back(checked_corners(corners));
      data_.labels.push_back(checked_labels(p, q));
    }
  }

  std::array<std::int64_t, 3> read_corners(const PlyProperty& list, std::uint64_t face) {
    const std::int64_t count = values_.next_integer(*list.count_type, "the number of corners");
    if (count != 3)
      values_.fail("face " + std::to_string(face) + " has " + std::to_string(count) +
                   " corners; triangulate the surface first");
    std::array<std::int64_t, 3> corners{};
    for (std::int64_t& corner : corners) corner = values_.next_integer(list.type, "a vertex number");
    return corners;
  }

  void skip(const PlyElement& element) {
    for (std::uint64_t i = 0; i < element.count; ++i)
      for (const PlyProperty& property : element.properties) values_.skip_property(property);
  }

  void reject(const std::string& problem) {
    if (!problem.empty()) values_.fail(problem);
  }
  void reject(const std::string& problem, const char* element, std::uint64_t number) {
    if (!problem.empty()) values_.fail(std::string(element) + " " + std::to_string(number) + ": " + problem);
  }

  static constexpr std::size_t nowhere = 7;
  const PlyHeader& header_;
  PlyValues& values_;
  SurfaceData data_;
};

}  // namespace

SurfaceData read_ply(const std::filesystem::path& path) {
  ByteReader bytes(path);
  const PlyHeader header = read_ply_header(bytes);
  SurfaceData data;
  if (header.encoding == PlyEncoding::Ascii) {
    PlyAsciiValues values(bytes, header.lines);
    data = PlyReader(header, values).read();
  } else {
    PlyBinaryValues values(bytes,
                           header.encoding == PlyEncoding::LittleEndian ? std::endian::little : std::endian::big);
    data = PlyReader(header, values).read();
  }
  require_edges_in_range(data, bytes.name());
  return data;
}

}  // namespace lostopos
