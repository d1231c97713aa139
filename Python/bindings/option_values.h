#pragma once

#include <pybind11/pybind11.h>

#include "Base/options/option_set.h"

namespace foamsim::python {

/// Sets an option as Python gives it: bool, int, float, str (read as on the command line), or a list of words. Throws
/// base::InputError of one line, as on the command line.
void set_option(base::OptionSet& options, const std::string& key, const pybind11::handle& value);

/// What an option holds.
pybind11::object option_of(const base::OptionSet& options, const std::string& key);

/// All of them, by key.
pybind11::dict options_dict(const base::OptionSet& options);

}  // namespace foamsim::python
