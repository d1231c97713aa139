#include "Base/interruption.h"
#include "FoamSim/version.h"
#include "Python/bindings/bindings.h"

namespace foamsim::python {

void bind_errors(pybind11::module_& module) {
  namespace py = pybind11;
  // The last one registered is asked first.
  py::register_exception<base::Error>(module, "Error", PyExc_RuntimeError);
  py::register_exception<base::InputError>(module, "InputError", PyExc_ValueError);
  // NOLINTNEXTLINE(performance-unnecessary-value-param): pybind11 takes a function of this type.
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error) std::rethrow_exception(error);
    } catch (const base::Interrupted&) {
      PyErr_SetNone(PyExc_KeyboardInterrupt);
    }
  });
}

}  // namespace foamsim::python

PYBIND11_MODULE(_foamsim, module) {
  module.doc() = "The compiled part of foamsim.";
  module.attr("__version__") = foamsim::version;
  foamsim::python::bind_errors(module);
  foamsim::python::bind_catalogue(module);
  foamsim::python::bind_simulation(module);
  foamsim::python::bind_files(module);
}
