#pragma once

#include <pybind11/pybind11.h>

namespace foamsim::python {

/// @name The parts of the module _foamsim
///@{
void bind_errors(pybind11::module_& module);
void bind_catalogue(pybind11::module_& module);
void bind_simulation(pybind11::module_& module);
void bind_files(pybind11::module_& module);
///@}

}  // namespace foamsim::python
