#include "FoamSim/run/picture_fields.h"

#include <algorithm>
#include <array>

#include "Base/error.h"
#include "FoamSim/sheet/pressure/curvature.h"
#include "FoamSim/sheet/pressure/vertex_area/averaged.h"
#include "FoamSim/sheet/sheet_strength.h"
#include "LosTopos/io/film_faces.h"

namespace foamsim {

using lostopos::DataArray;
using lostopos::SurfaceData;
using lostopos::Vec3;
using lostopos::Vertex;

namespace {

// The surface with films oriented, and the handles of its vertices and triangles in their order.
class FilmPicture {
 public:
  FilmPicture(const Simulation& simulation, const PictureSetup& setup)
      : simulation_(simulation), setup_(setup), data_(film_picture(lostopos::from_mesh(simulation.mesh()))) {
    vertices_.assign(simulation.mesh().vertices().begin(), simulation.mesh().vertices().end());
  }

  const SurfaceData& data() const { return data_; }
  SurfaceData take() && { return std::move(data_); }
  void add_to_vertices(DataArray array) { data_.vertex_arrays.push_back(std::move(array)); }
  void add_to_triangles(DataArray array) { data_.triangle_arrays.push_back(std::move(array)); }

  DataArray film() const {
    const auto numbers = lostopos::film_numbers(data_);
    return {"film", 1, std::vector<double>(numbers.begin(), numbers.end())};
  }

  DataArray circulation() const {
    return mean_of_corners("circulation", "L^2/T",
                           [&](Vertex v, lostopos::Labels pq) { return simulation_.circulation().get(v, pq); });
  }

  // Half of what the two regions' sums of principal curvatures differ by is that sum; H, their mean, half of it again.
  DataArray curvature(const char* name, const char* unit, double factor) const {
    CurvatureField field;
    const SurfaceGeometry& geometry = simulation_.geometry();
    field.update(simulation_.mesh(), geometry, EdgeAngleCurvature(std::make_unique<AveragedArea>()));
    return mean_of_corners(name, unit, [&](Vertex v, lostopos::Labels pq) {
      return factor * (field.get(geometry, v, pq.p) - field.get(geometry, v, pq.q)) / 4;
    });
  }
  DataArray mean_curvature() const { return curvature("mean_curvature", "1/L", 1); }
  DataArray pressure_jump() const { return curvature("pressure_jump", "L^2/T^2", 4 * setup_.sigma); }

  DataArray strength() const {
    DataArray array{"sheet_strength", 3, {}, "L/T"};
    for (std::size_t t = 0; t < data_.triangles.size(); ++t) {
      const std::array<Vec3, 3> x = corners(t);
      std::array<double, 3> gamma{};
      for (std::size_t i = 0; i < 3; ++i)
        gamma[i] = simulation_.circulation().get(vertices_[data_.triangles[t][i]], data_.labels[t]);
      const double area = area_vector(t).norm();
      append(array, area > 0 ? Vec3(sheet_strength(x, gamma) / area) : Vec3(Vec3::Zero()));
    }
    return array;
  }

  DataArray velocity() const {
    std::vector<SheetTriangle> sheet;
    VortexSources sources;
    gather_sheet(simulation_.mesh(), simulation_.circulation(), sheet, simulation_.solid());
    fill_vortex_sources(sheet, simulation_.mesh().positions(), sources);
    std::vector<Vec3> velocities(data_.positions.size());
    setup_.velocity.velocities(sources, data_.positions, simulation_.delta(), velocities);
    DataArray array{"velocity", 3, {}, "L/T"};
    for (const Vec3& u : velocities) append(array, u);
    return array;
  }

  DataArray normal() const {
    std::vector<Vec3> sums(data_.positions.size(), Vec3::Zero());
    for (std::size_t t = 0; t < data_.triangles.size(); ++t)
      for (const std::uint32_t v : data_.triangles[t]) sums[v] += area_vector(t);
    DataArray array{"normal", 3, {}};
    for (const Vec3& sum : sums) append(array, sum.norm() > 0 ? Vec3(sum.normalized()) : Vec3(Vec3::Zero()));
    return array;
  }

  // One where at least so many Plateau borders end.
  DataArray flag(const char* name, int borders) const {
    std::vector<int> ends(data_.positions.size());
    for (const auto& line : data_.lines)
      for (const std::uint32_t v : line) ++ends[v];
    DataArray array{name, 1, {}};
    for (const int count : ends) array.values.push_back(count >= borders ? 1 : 0);
    return array;
  }
  DataArray border() const { return flag("border", 1); }
  DataArray plateau_vertex() const { return flag("plateau_vertex", 3); }

  DataArray held() const {
    DataArray array{"held", 1, {}};
    for (const Vertex v : vertices_) {
      const bool is_held = v.index() < simulation_.held().size() && lostopos::is_held(simulation_.held()[v.index()]);
      array.values.push_back(is_held ? 1 : 0);
    }
    return array;
  }

 private:
  static void append(DataArray& array, const Vec3& value) {
    for (int i = 0; i < 3; ++i) array.values.push_back(value[i]);
  }

  std::array<Vec3, 3> corners(std::size_t t) const {
    const auto& [a, b, c] = data_.triangles[t];
    return {data_.positions[a], data_.positions[b], data_.positions[c]};
  }
  Vec3 area_vector(std::size_t t) const {
    const std::array<Vec3, 3> x = corners(t);
    return 0.5 * (x[1] - x[0]).cross(x[2] - x[0]);
  }

  template <class Value>
  DataArray mean_of_corners(const char* name, const char* unit, Value value) const {
    DataArray array{name, 1, {}, unit};
    for (std::size_t t = 0; t < data_.triangles.size(); ++t) {
      double sum = 0;
      for (const std::uint32_t v : data_.triangles[t]) sum += value(vertices_[v], data_.labels[t]);
      array.values.push_back(sum / 3);
    }
    return array;
  }

  const Simulation& simulation_;
  const PictureSetup& setup_;
  SurfaceData data_;
  std::vector<Vertex> vertices_;
};

struct PictureField {
  const char* name;
  void (*add)(FilmPicture&);
};

template <DataArray (FilmPicture::*Make)() const>
void add_vertex_field(FilmPicture& picture) {
  picture.add_to_vertices((picture.*Make)());
}
template <DataArray (FilmPicture::*Make)() const>
void add_triangle_field(FilmPicture& picture) {
  picture.add_to_triangles((picture.*Make)());
}

constexpr std::array<PictureField, 10> film_fields{
    {{"film", add_triangle_field<&FilmPicture::film>},
     {"circulation", add_triangle_field<&FilmPicture::circulation>},
     {"mean_curvature", add_triangle_field<&FilmPicture::mean_curvature>},
     {"pressure_jump", add_triangle_field<&FilmPicture::pressure_jump>},
     {"sheet_strength", add_triangle_field<&FilmPicture::strength>},
     {"velocity", add_vertex_field<&FilmPicture::velocity>},
     {"normal", add_vertex_field<&FilmPicture::normal>},
     {"border", add_vertex_field<&FilmPicture::border>},
     {"plateau_vertex", add_vertex_field<&FilmPicture::plateau_vertex>},
     {"held", add_vertex_field<&FilmPicture::held>}}};

// A film's own fields are not taken twice: an attribute of such a name is what the simulation keeps of it.
bool is_film_field(const std::string& name) {
  return std::ranges::any_of(film_fields, [&](const PictureField& field) { return field.name == name; });
}

template <class Range>
void append_names(const Range& columns, std::vector<std::string>& names) {
  for (const lostopos::NamedAttributeColumn* column : columns)
    if (column->components() > 0 && std::ranges::find(names, column->name()) == names.end())
      names.push_back(column->name());
}

[[noreturn]] void throw_unknown_field(const std::string& name, const std::vector<std::string>& known) {
  std::string list = all_fields;
  for (const std::string& field : known) list.append(", ").append(field);
  throw base::InputError("option 'fields': there is no field '" + name + "' in this scene; there are: " + list);
}

}  // namespace

std::vector<std::string> picture_field_names(const Simulation& simulation) {
  std::vector<std::string> names;
  names.reserve(film_fields.size());
  for (const PictureField& field : film_fields) names.emplace_back(field.name);
  append_names(simulation.mesh().named_vertex_attributes(), names);
  append_names(simulation.mesh().named_triangle_attributes(), names);
  return names;
}

void require_picture_fields(const Simulation& simulation, std::span<const std::string> names) {
  const std::vector<std::string> known = picture_field_names(simulation);
  for (const std::string& name : names)
    if (name != all_fields && std::ranges::find(known, name) == known.end()) throw_unknown_field(name, known);
}

SurfaceData picture_of(const Simulation& simulation, const PictureSetup& setup) {
  require_picture_fields(simulation, setup.fields);
  const auto wanted = [&](const std::string& name) {
    return std::ranges::find(setup.fields, name) != setup.fields.end() ||
           std::ranges::find(setup.fields, all_fields) != setup.fields.end();
  };
  FilmPicture picture(simulation, setup);
  for (const PictureField& field : film_fields)
    if (wanted(field.name)) field.add(picture);
  SurfaceData attributes = lostopos::from_mesh_with_attributes(simulation.mesh());
  const auto add = [&](DataArray& array, void (FilmPicture::*add_to)(DataArray)) {
    if (!wanted(array.name) || is_film_field(array.name)) return;
    if (array.name == "motion") array.unit = "L";
    (picture.*add_to)(std::move(array));
  };
  for (DataArray& array : attributes.vertex_arrays) add(array, &FilmPicture::add_to_vertices);
  for (DataArray& array : attributes.triangle_arrays) add(array, &FilmPicture::add_to_triangles);
  return std::move(picture).take();
}

}  // namespace foamsim
