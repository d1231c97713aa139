#include "Python/bindings/python_effect.h"

#include <nlohmann/json.hpp>

#include "Base/error.h"
#include "Python/bindings/arrays.h"

namespace foamsim::python {

namespace py = pybind11;
using lostopos::Vec3;

namespace {

py::object json_module() {
  return py::module_::import("json");
}

// Living triangles, by numbers of vertex slots.
void add_triangles(const lostopos::SurfaceMesh& mesh, py::object& step) {
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::vector<lostopos::Labels> labels;
  for (lostopos::Triangle t : mesh.triangles()) {
    const auto& v = mesh.vertices(t);
    triangles.push_back({v[0].index(), v[1].index(), v[2].index()});
    labels.push_back(mesh.labels(t));
  }
  step.attr("triangles") = corners(triangles);
  step.attr("labels") = label_pairs(labels);
}

py::object step_object(const lostopos::SurfaceMesh& mesh, double time, double dt, std::span<const Vec3> positions) {
  py::object step = py::module_::import("types").attr("SimpleNamespace")();
  step.attr("time") = time;
  step.attr("dt") = dt;
  step.attr("positions") = vectors(positions);
  add_triangles(mesh, step);
  return step;
}

lostopos::VertexAttribute<double> make_attribute(lostopos::SurfaceMesh& mesh, const std::string& name,
                                                 const py::handle& given) {
  const bool pair = py::isinstance<py::tuple>(given) && py::len(given) == 2;
  const auto initial = pair ? given[py::int_(0)].cast<double>() : given.cast<double>();
  const std::string carry = pair ? given[py::int_(1)].cast<std::string>() : std::string("interpolate");
  if (carry == "interpolate") return mesh.add_vertex_attribute<double>(name, lostopos::carry::interpolate, initial);
  if (carry == "conserve") return mesh.add_vertex_attribute<double>(name, lostopos::carry::conserve, initial);
  if (carry == "copy") return mesh.add_vertex_attribute<double>(name, lostopos::carry::copy, initial);
  throw base::InputError("attribute '" + name + "': '" + carry +
                         "' is no way to carry it; there are interpolate, conserve, copy");
}

void add_rows(const py::object& rows, const std::string& what, std::span<Vec3> to) {
  if (rows.is_none()) return;
  const std::vector<Vec3> added = to_vectors(rows, what, to.size());
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += added[i];
}

}  // namespace

PythonEffect::PythonEffect(std::string name, py::object object)
    : name_(std::move(name)), object_(hold(std::move(object))), lets_burst_(object_->attr("lets_burst").cast<bool>()) {}

std::string PythonEffect::result_of(const char* hook) const {
  return "effect '" + name_ + "', " + hook;
}

py::object PythonEffect::call(const char* hook, const EffectStep& step, double time,
                              std::span<const Vec3> positions) const {
  return object_->attr(hook)(step_object(step.mesh, time, step.dt, positions));
}

void PythonEffect::attach(lostopos::SurfaceMesh& mesh) {
  const py::gil_scoped_acquire lock;
  mesh_ = &mesh;
  for (const auto& [name, given] : object_->attr("attributes").cast<py::dict>())
    attributes_.push_back(make_attribute(mesh, name.cast<std::string>(), given));
}

std::vector<lostopos::Region> PythonEffect::bursts(const EffectStep& step) {
  if (!lets_burst_) return {};
  const py::gil_scoped_acquire lock;
  std::vector<lostopos::Region> regions;
  const py::object given = call("bursts", step, step.time, step.mesh.positions());
  if (given.is_none()) return regions;
  for (const py::handle region : given) {
    const auto number = region.cast<long>();
    const lostopos::Region burst(static_cast<std::size_t>(number));
    if (number <= 0 || !std::ranges::any_of(step.mesh.triangles(),
                                            [&](lostopos::Triangle t) { return step.mesh.labels(t).has(burst); }))
      throw base::InputError(result_of("bursts") + ": the surface has no region " + std::to_string(number));
    regions.push_back(burst);
  }
  return regions;
}

std::vector<Vec3> PythonEffect::displaced(const EffectStep& step) {
  const py::gil_scoped_acquire lock;
  const py::object given = call("displaced", step, step.time, step.mesh.positions());
  if (given.is_none()) return {};
  return to_vectors(given, result_of("displaced"), step.mesh.vertex_slots());
}

void PythonEffect::update_circulation(const EffectStep& step, CirculationField& /*circulation*/) {
  const py::gil_scoped_acquire lock;
  py::object seen = step_object(step.mesh, step.time, step.dt, step.mesh.positions());
  py::dict arrays;
  std::vector<py::array_t<double>> copies;
  auto names = object_->attr("attributes").cast<py::dict>().begin();
  for (auto& attribute : attributes_) {
    copies.emplace_back(static_cast<py::ssize_t>(attribute.slots().size()), attribute.slots().data());
    arrays[(*names).first] = copies.back();
    ++names;
  }
  seen.attr("attributes") = arrays;
  object_->attr("update")(seen);
  for (std::size_t i = 0; i < copies.size(); ++i)
    std::copy_n(copies[i].data(), attributes_[i].slots().size(), attributes_[i].slots().begin());
}

void PythonEffect::add_force(const Stage& stage, std::span<Vec3> force) {
  const py::gil_scoped_acquire lock;
  add_rows(call("add_force", stage.step, stage.time, stage.positions), result_of("add_force"), force);
}

void PythonEffect::add_velocity(const Stage& stage, std::span<Vec3> velocity) {
  const py::gil_scoped_acquire lock;
  add_rows(call("add_velocity", stage.step, stage.time, stage.positions), result_of("add_velocity"), velocity);
}

void PythonEffect::move_vertices(const Stage& stage, std::span<Vec3> positions) {
  const py::gil_scoped_acquire lock;
  const py::object given = call("move_vertices", stage.step, stage.time, stage.positions);
  if (given.is_none()) return;
  std::ranges::copy(to_vectors(given, result_of("move_vertices"), positions.size()), positions.begin());
}

double PythonEffect::potential_energy(const SurfaceGeometry& /*geometry*/) const {
  if (mesh_ == nullptr) return 0;
  const py::gil_scoped_acquire lock;
  return object_->attr("potential_energy")(step_object(*mesh_, 0, 0, mesh_->positions())).cast<double>();
}

double PythonEffect::potential_energy(const Stage& stage) const {
  const py::gil_scoped_acquire lock;
  return call("potential_energy", stage.step, stage.time, stage.positions).cast<double>();
}

nlohmann::json PythonEffect::state() const {
  const py::gil_scoped_acquire lock;
  return nlohmann::json::parse(json_module().attr("dumps")(object_->attr("state")()).cast<std::string>());
}

void PythonEffect::restore(const nlohmann::json& state) {
  const py::gil_scoped_acquire lock;
  object_->attr("restore")(json_module().attr("loads")(state.dump()));
}

}  // namespace foamsim::python
