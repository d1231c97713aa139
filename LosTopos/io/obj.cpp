#include "LosTopos/io/obj.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "Base/io/atomic_file.h"
#include "Base/io/number_text.h"
#include "LosTopos/io/byte_reader.h"
#include "LosTopos/io/film_faces.h"
#include "LosTopos/io/read_error.h"
#include "LosTopos/io/surface_checks.h"
#include "LosTopos/io/text_reader.h"

namespace lostopos {
namespace {

constexpr std::string_view group_prefix = "region_";
// OBJ has no place for these: comments to other programs.
constexpr std::string_view velocity_line = "#velocity", vertex_id_line = "#vertex_id";
constexpr std::array<std::string_view, 9> passed_over{"vt", "vn", "vp", "o", "s", "usemtl", "mtllib", "l", "p"};

class ObjReader {
 public:
  explicit ObjReader(const std::filesystem::path& path)
      : name_(path.string()), text_(ByteReader(path).read_text(), name_) {}

  SurfaceData read() {
    if (text_.remaining() == 0) text_.fail("the file is empty; an OBJ file has lines such as 'v 0 0 1' and 'f 1 2 3'");
    while (text_.next_line()) {
      std::string_view rest = text_.line();
      const std::string_view keyword = take_word(rest);
      if (keyword == "v") {
        read_vertex(rest);
      } else if (keyword == "f") {
        read_face(rest);
      } else if (keyword == "g") {
        read_group(rest);
      } else if (keyword == velocity_line) {
        read_numbers(rest, 3, velocities_);
      } else if (keyword == vertex_id_line) {
        read_numbers(rest, 1, vertex_ids_);
      } else if (!keyword.empty() && keyword[0] != '#' &&
                 std::ranges::find(passed_over, keyword) == passed_over.end()) {
        text_.fail(in_quotes(keyword) + " is no statement of a polygonal OBJ file; v, f and g lines are wanted");
      }
    }
    if (largest_corner_ > static_cast<std::int64_t>(data_.positions.size()))
      throw_at_line(name_, largest_corner_line_,
                    "the face names vertex " + std::to_string(largest_corner_) + ", but the file has only " +
                        std::to_string(data_.positions.size()));
    require_edges_in_range(data_, name_);
    take_array({velocity_array, 3, std::move(velocities_), "L/T"}, velocity_line);
    take_array({vertex_id_array, 1, std::move(vertex_ids_)}, vertex_id_line);
    return std::move(data_);
  }

 private:
  void read_vertex(std::string_view rest) {
    Vec3 position;
    for (int i = 0; i < 3; ++i) {
      const std::string_view word = take_word(rest);
      const auto value = base::parse_double(word);
      if (!value) text_.fail(in_quotes(word) + " stands where a coordinate should; 'v 0.5 0 -1' would be right");
      position[i] = *value;
    }
    reject(position_problem(position));
    data_.positions.push_back(position);
    reject(vertex_count_problem(data_.positions.size()));
  }

  void read_face(std::string_view rest) {
    std::array<std::int64_t, 3> corners{};
    std::size_t count = 0;
    for (std::string_view word = take_word(rest); !word.empty() && word[0] != '#'; word = take_word(rest)) {
      if (count < 3) corners[count] = corner(word);
      ++count;
    }
    if (count != 3)
      text_.fail("the face has " + std::to_string(count) + " corners, not 3" +
                 (count > 3 ? "; triangulate the surface first" : ""));
    // A face may name vertices of later lines, so that the upper bound is known at the end only.
    reject(corner_problem(corners, most_vertices, 1));
    if (const std::int64_t largest = *std::ranges::max_element(corners) + 1; largest > largest_corner_) {
      largest_corner_ = largest;
      largest_corner_line_ = text_.line_number();
    }
    data_.triangles.push_back(checked_corners(corners));
    data_.labels.push_back(labels_);
    reject(triangle_count_problem(data_.triangles.size()));
  }

  // Number, from 0, of the vertex that "7", "7/2", "7//3", "7/2/3" or "-1" stands for.
  std::int64_t corner(std::string_view word) {
    const auto number = base::parse_integer(word.substr(0, word.find('/')));
    const auto have = static_cast<std::int64_t>(data_.positions.size());
    if (!number || *number == 0 || *number < -have)
      text_.fail(in_quotes(word) + " stands where a corner should, with " + std::to_string(have) +
                 " vertices so far; a vertex number from 1, or from -1 backwards, would be right");
    return *number > 0 ? *number - 1 : have + *number;
  }

  void read_group(std::string_view rest) {
    labels_ = default_labels;
    for (std::string_view word = take_word(rest); !word.empty(); word = take_word(rest)) {
      if (!word.starts_with(group_prefix)) continue;
      const std::string_view numbers = word.substr(group_prefix.size());
      // region_north is somebody else's group; region_1_x is meant to be ours.
      if (numbers.find_first_of("0123456789-") != 0) continue;
      const std::size_t bar = std::min(numbers.find('_'), numbers.size() - 1);
      const auto p = base::parse_integer(numbers.substr(0, bar)), q = base::parse_integer(numbers.substr(bar + 1));
      if (!p || !q) text_.fail("group " + in_quotes(word) + " names no two regions; 'region_1_0' would be right");
      reject(label_problem(*p, *q));
      labels_ = checked_labels(*p, *q);
    }
  }

  // Of a line that belongs to the vertex before it.
  void read_numbers(std::string_view rest, int count, std::vector<double>& numbers) {
    for (int i = 0; i < count; ++i) {
      const std::string_view word = take_word(rest);
      const auto value = base::parse_double(word);
      if (!value) text_.fail(in_quotes(word) + " stands where a number of the vertex should");
      numbers.push_back(*value);
    }
    if (numbers.size() > static_cast<std::size_t>(count) * data_.positions.size())
      text_.fail("this line has no vertex of its own before it");
  }

  void take_array(DataArray array, std::string_view line) {
    if (array.values.empty()) return;
    if (array.values.size() != static_cast<std::size_t>(array.components) * data_.positions.size())
      text_.fail("some vertices have a line '" + std::string(line) + "' and others none; each or none would be right");
    data_.vertex_arrays.push_back(std::move(array));
  }

  void reject(const std::string& problem) {
    if (!problem.empty()) text_.fail(problem);
  }

  std::string name_;
  TextReader text_;
  SurfaceData data_;
  std::vector<double> velocities_, vertex_ids_;
  Labels labels_ = default_labels;
  std::int64_t largest_corner_ = 0;  // counted from 1
  std::size_t largest_corner_line_ = 0;
};

void append_integer(std::string& text, std::uint32_t value) {
  base::append_number(text, static_cast<std::int64_t>(value));
}

// "v 1 0 0"
std::string line_of(std::string_view keyword, std::span<const double> numbers) {
  std::string line(keyword);
  for (const double number : numbers) base::append_number(line += ' ', number);
  return line += '\n';
}

std::string line_of(std::string_view keyword, const Vec3& numbers) {
  return line_of(keyword, std::span<const double>(numbers.data(), 3));
}

void write_vertices(std::ostream& out, const SurfaceData& data) {
  const DataArray* velocity = find_array(data.vertex_arrays, velocity_array);
  const DataArray* vertex_id = find_array(data.vertex_arrays, vertex_id_array);
  for (std::size_t v = 0; v < data.positions.size(); ++v) {
    out << line_of("v", data.positions[v]);
    if (velocity != nullptr && velocity->components == 3)
      out << line_of(velocity_line, std::span(velocity->values).subspan(3 * v, 3));
    if (vertex_id != nullptr && holds_vertex_ids(*vertex_id))
      out << line_of(vertex_id_line, std::span(vertex_id->values).subspan(v, 1));
  }
}

// Of every vertex, of unit length; zero where its triangles' cancel.
std::vector<Vec3> normals_of(const SurfaceData& data) {
  std::vector<Vec3> normals(data.positions.size(), Vec3::Zero());
  for (std::size_t t = 0; t < data.triangles.size(); ++t) {
    const auto& [a, b, c] = data.triangles[t];
    const Vec3& x = data.positions[a];
    const Vec3 across = (data.positions[b] - x).cross(data.positions[c] - x);
    const double side = data.labels[t].q < data.labels[t].p ? 1 : -1;
    for (const std::uint32_t corner : data.triangles[t]) normals[corner] += side * across;
  }
  for (Vec3& normal : normals) normal = normal.normalized();
  return normals;
}

// The triangles' numbers, film by film.
std::vector<std::uint32_t> by_films(const std::vector<std::uint32_t>& films) {
  std::vector<std::uint32_t> order(films.size());
  std::iota(order.begin(), order.end(), 0U);
  std::ranges::stable_sort(order, {}, [&films](std::uint32_t t) { return films[t]; });
  return order;
}

std::string group_of(Labels labels, std::uint32_t film) {
  std::string line = "g " + std::string(group_prefix);
  append_integer(line, std::max(labels.p, labels.q).index());
  append_integer(line += '_', std::min(labels.p, labels.q).index());
  append_integer(line += " film_", film);
  return line += '\n';
}

void write_faces(std::ostream& out, const SurfaceData& data, ObjNormals normals) {
  const std::vector<std::uint32_t> films = film_numbers(data);
  std::optional<std::uint32_t> film;
  for (const std::uint32_t t : by_films(films)) {
    if (film != films[t]) out << group_of(data.labels[t], films[t]);
    film = films[t];
    std::array<std::uint32_t, 3> corners = data.triangles[t];
    if (data.labels[t].p < data.labels[t].q) std::swap(corners[1], corners[2]);
    std::string line = "f";
    for (const std::uint32_t corner : corners) {
      append_integer(line += ' ', corner + 1);
      if (normals == ObjNormals::with) append_integer(line += "//", corner + 1);
    }
    out << (line += '\n');
  }
}

}  // namespace

SurfaceData read_obj(const std::filesystem::path& path) {
  return ObjReader(path).read();
}

void write_obj(const std::filesystem::path& path, const SurfaceData& data, ObjNormals normals) {
  validate(data);
  base::AtomicFile file(path);
  file.stream() << "# groups region_P_Q film_N, one a film: right-hand normals point out of region P into region Q; 0 "
                   "is the open air\n";
  write_vertices(file.stream(), data);
  if (normals == ObjNormals::with)
    for (const Vec3& normal : normals_of(data)) file.stream() << line_of("vn", normal);
  write_faces(file.stream(), data, normals);
  file.commit();
}

void write_obj(const std::filesystem::path& path, const SurfaceData& data) {
  write_obj(path, data, ObjNormals::without);
}

}  // namespace lostopos
