#include "FoamSim/scenes/catalogue.h"

#include <pybind11/stl.h>

#include "FoamSim/scenes/scene_options.h"
#include "LosTopos/io/surface_data.h"
#include "Python/bindings/arrays.h"
#include "Python/bindings/bindings.h"
#include "Python/bindings/option_values.h"
#include "Python/bindings/python_area.h"
#include "Python/bindings/python_effect.h"

namespace foamsim::python {

namespace py = pybind11;

namespace {

template <class Entry>
py::dict summaries(const base::Registry<Entry>& registry) {
  py::dict all;
  for (const Entry& entry : registry) all[py::str(entry.name)] = entry.summary;
  return all;
}

// Numbers, by key, with their defaults.
std::vector<base::OptionSpec> specs_of(const py::dict& options, const std::string& owner) {
  std::vector<base::OptionSpec> specs;
  for (const auto& [key, value] : options)
    specs.push_back({key.cast<std::string>(), value.cast<double>(), "an option of " + owner, "a number"});
  return specs;
}

// The object that make(options) gives.
py::object made(const HeldObject& make, const base::OptionSet& options) {
  return (*make)(options_dict(options));
}

void add_effect(Catalogue& catalogue, const std::string& name, py::object make, const std::string& summary,
                const py::dict& options) {
  catalogue.effects.add(
      {name, summary, specs_of(options, name), [name, held = hold(std::move(make))](const EffectSetup& setup) {
         const py::gil_scoped_acquire lock;
         return std::make_unique<PythonEffect>(name, made(held, setup.options));
       }});
}

void add_area(Catalogue& catalogue, const std::string& name, py::object make, const std::string& summary,
              const py::dict& options) {
  catalogue.sheet.areas.add(
      {name, summary, specs_of(options, name), [name, held = hold(std::move(make))](const VertexAreaSetup& setup) {
         const py::gil_scoped_acquire lock;
         return std::make_unique<PythonArea>(name, made(held, setup.options));
       }});
}

void add_scene(Catalogue& catalogue, const std::string& name, py::object build, const std::string& summary,
               const py::dict& options) {
  SceneEntry entry{.name = name, .summary = summary, .options = specs_of(options, name), .defaults = {}, .build = {}};
  entry.build = [name, held = hold(std::move(build))](const base::OptionSet& set) {
    const py::gil_scoped_acquire lock;
    const py::object surface = made(held, set);
    if (!py::isinstance<py::tuple>(surface) || py::len(surface) != 3)
      throw base::InputError("scene '" + name + "': (positions, triangles, labels) is needed");
    return lostopos::to_mesh(to_surface(surface[py::int_(0)], surface[py::int_(1)], surface[py::int_(2)]));
  };
  catalogue.scenes.add(std::move(entry));
}

py::dict option_summaries(const Catalogue& catalogue, const std::string& scene) {
  py::dict all;
  const base::OptionSet options = options_of(catalogue, &catalogue.scenes.find(scene));
  for (const base::OptionSpec& spec : options.specs())
    all[py::str(spec.key)] = py::make_tuple(option_of(options, spec.key), spec.summary);
  return all;
}

}  // namespace

void bind_catalogue(py::module_& module) {
  using namespace py::literals;
  py::class_<Catalogue, std::shared_ptr<Catalogue>>(module, "Catalogue")
      .def(py::init([] { return std::make_shared<Catalogue>(*built_in_catalogue()); }))
      .def("add_effect", &add_effect, "name"_a, "make"_a, "summary"_a = "", "options"_a = py::dict())
      .def("add_area", &add_area, "name"_a, "make"_a, "summary"_a = "", "options"_a = py::dict())
      .def("add_scene", &add_scene, "name"_a, "build"_a, "summary"_a = "", "options"_a = py::dict())
      .def_property_readonly("scenes", [](const Catalogue& c) { return summaries(c.scenes); })
      .def_property_readonly("effects", [](const Catalogue& c) { return summaries(c.effects); })
      .def_property_readonly("areas", [](const Catalogue& c) { return summaries(c.sheet.areas); })
      .def_property_readonly("constraints", [](const Catalogue& c) { return summaries(c.constraints); })
      .def_property_readonly("integrators", [](const Catalogue& c) { return summaries(c.integrators); })
      .def_property_readonly("dynamics", [](const Catalogue& c) { return summaries(c.dynamics); })
      .def("options", &option_summaries, "scene"_a);
}

}  // namespace foamsim::python
