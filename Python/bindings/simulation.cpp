#include <pybind11/stl.h>

#include "Base/error.h"
#include "FoamSim/metrics/metrics_csv.h"
#include "LosTopos/io/mesh_file.h"
#include "Python/bindings/arrays.h"
#include "Python/bindings/bindings.h"
#include "Python/bindings/option_values.h"
#include "Python/bindings/session.h"

namespace foamsim::python {

namespace py = pybind11;
using lostopos::SurfaceMesh;

namespace {

/// The surface of a simulation, as it is when it is looked at.
struct MeshView {
  std::shared_ptr<Session> session;
  const SurfaceMesh& mesh() const { return session->motion().mesh(); }
};

std::shared_ptr<Session> make_session(const std::string& what, const py::dict& options,
                                      const std::shared_ptr<Catalogue>& catalogue) {
  Scene scene = load_scene(what, std::make_shared<Catalogue>(*catalogue));
  for (const auto& [key, value] : options) set_option(scene.options, key.cast<std::string>(), value);
  validate(scene);
  return std::make_shared<Session>(scene);
}

py::array positions(const MeshView& view) {
  const auto x = view.mesh().positions();
  return view.session->view(py::dtype::of<double>(), {static_cast<py::ssize_t>(x.size()), 3}, x.data(), false);
}

py::array triangles(const MeshView& view) {
  const SurfaceMesh& mesh = view.mesh();
  static_assert(sizeof(std::array<lostopos::Vertex, 3>) == 3 * sizeof(std::uint32_t));
  return view.session->view(py::dtype::of<std::uint32_t>(), {static_cast<py::ssize_t>(mesh.triangle_slots()), 3},
                            mesh.vertices(lostopos::Triangle(0)).data(), false);
}

py::array labels(const MeshView& view) {
  const SurfaceMesh& mesh = view.mesh();
  std::vector<lostopos::Labels> all;
  for (std::size_t t = 0; t < mesh.triangle_slots(); ++t) all.push_back(mesh.labels(lostopos::Triangle(t)));
  return label_pairs(all);
}

template <class H>
py::array alive(const MeshView& view, std::size_t slots) {
  py::array_t<bool> mask(static_cast<py::ssize_t>(slots));
  for (std::size_t i = 0; i < slots; ++i) mask.mutable_data()[i] = view.mesh().alive(H(i));
  return mask;
}

// Named attributes that are numbers or vectors; those of other types are left out.
py::dict attributes(const MeshView& view, std::span<lostopos::NamedAttributeColumn* const> columns) {
  using lostopos::ValueColumn;
  py::dict all;
  for (lostopos::NamedAttributeColumn* column : columns) {
    if (auto* numbers = dynamic_cast<ValueColumn<double, lostopos::NamedAttributeColumn>*>(column))
      all[py::str(column->name())] = view.session->view(
          py::dtype::of<double>(), {static_cast<py::ssize_t>(numbers->values.size())}, numbers->values.data(), true);
    else if (auto* vectors = dynamic_cast<ValueColumn<lostopos::Vec3, lostopos::NamedAttributeColumn>*>(column))
      all[py::str(column->name())] = view.session->view(
          py::dtype::of<double>(), {static_cast<py::ssize_t>(vectors->values.size()), 3}, vectors->values.data(), true);
  }
  return all;
}

py::tuple compact(const MeshView& view) {
  const lostopos::SurfaceData data = lostopos::from_mesh(view.mesh());
  return py::make_tuple(vectors(data.positions), corners(data.triangles), label_pairs(data.labels));
}

py::array solid(const MeshView& view) {
  const SurfaceMesh& mesh = view.mesh();
  std::vector<bool> all;
  for (lostopos::Triangle t : mesh.triangles())
    all.push_back(view.session->motion().simulation().solid()[t.index()] != 0);
  return py::array(py::cast(all));
}

void write(const Session& session, const std::string& path) {
  const std::filesystem::path file(path);
  lostopos::write_surface(file, file.extension() == ".vtp" ? session.motion().picture() : session.motion().record());
}

py::tuple metrics(const Session& session) {
  const Metrics& metrics = session.motion().metrics();
  py::dict volumes;
  for (const lostopos::RegionVolume& volume : metrics.volumes) volumes[py::int_(volume.region.index())] = volume.volume;
  return py::make_tuple(metrics_header(), metrics_row(metrics), volumes);
}

}  // namespace

void bind_simulation(py::module_& module) {
  using namespace py::literals;
  py::class_<MeshView>(module, "Mesh")
      .def_property_readonly("positions", &positions)
      .def_property_readonly("triangles", &triangles)
      .def_property_readonly("labels", &labels)
      .def_property_readonly("vertex_alive",
                             [](const MeshView& v) { return alive<lostopos::Vertex>(v, v.mesh().vertex_slots()); })
      .def_property_readonly("triangle_alive",
                             [](const MeshView& v) { return alive<lostopos::Triangle>(v, v.mesh().triangle_slots()); })
      .def_property_readonly("vertex_attributes",
                             [](const MeshView& v) { return attributes(v, v.mesh().named_vertex_attributes()); })
      .def_property_readonly("triangle_attributes",
                             [](const MeshView& v) { return attributes(v, v.mesh().named_triangle_attributes()); })
      .def_property_readonly("solid", &solid)
      .def("compact", &compact);
  py::class_<Session, std::shared_ptr<Session>>(module, "Simulation")
      .def(py::init(&make_session), "scene"_a, "options"_a, "catalogue"_a)
      .def(py::init([](const std::string& checkpoint, const std::shared_ptr<Catalogue>& catalogue) {
             return std::make_shared<Session>(std::filesystem::path(checkpoint),
                                              std::make_shared<Catalogue>(*catalogue));
           }),
           "checkpoint"_a, "catalogue"_a)
      .def("step", &Session::step)
      .def("set", &Session::set, "option"_a, "value"_a)
      .def("get", [](const Session& s, const std::string& key) { return option_of(s.motion().scene().options, key); })
      .def_property_readonly("options", [](const Session& s) { return options_dict(s.motion().scene().options); })
      .def_property_readonly("scene", [](const Session& s) { return s.motion().scene().name; })
      .def_property_readonly("steps", [](const Session& s) { return s.motion().steps(); })
      .def_property_readonly("time", [](const Session& s) { return s.motion().time(); })
      .def_property_readonly("dt", [](const Session& s) { return s.motion().simulation().options().dt; })
      .def_property_readonly("resolution", [](const Session& s) { return s.motion().simulation().resolution(); })
      .def_property_readonly("at_rest", [](const Session& s) { return s.motion().at_rest(); })
      .def_property_readonly("mesh", [](const std::shared_ptr<Session>& s) { return MeshView{s}; })
      .def("_metrics", &metrics)
      .def("write", &write, "path"_a)
      .def(
          "save", [](const Session& s, const std::string& path) { s.save(path); }, "checkpoint"_a);
}

}  // namespace foamsim::python
