#include "Python/bindings/option_values.h"

#include <pybind11/stl.h>

#include "Base/error.h"

namespace foamsim::python {

namespace py = pybind11;

namespace {

constexpr std::string_view where = "options";

std::vector<std::string> words_of(const py::handle& list) {
  std::vector<std::string> words;
  for (const py::handle word : list) words.push_back(py::str(word));
  return words;
}

base::OptionValue number_of(const std::string& key, const py::handle& value) {
  if (PyIndex_Check(value.ptr()) != 0) {
    const long whole = PyLong_AsLong(py::int_(py::reinterpret_borrow<py::object>(value)).ptr());
    if (whole == -1 && PyErr_Occurred() != nullptr) {
      PyErr_Clear();
      throw base::InputError(std::string(where) + ": " + key + ": the whole number is too large");
    }
    return whole;
  }
  const double number = PyFloat_AsDouble(value.ptr());
  if (PyErr_Occurred() != nullptr) {
    PyErr_Clear();
    throw base::InputError(std::string(where) + ": " + key + ": a " +
                           std::string(py::str(py::type::of(value).attr("__name__"))) +
                           " is no value of an option; give a bool, a number, a str or a list of str");
  }
  return number;
}

template <class T>
py::object to_python(const T& value) {
  return py::cast(value);
}
py::object to_python(const base::Words& words) {
  return py::cast(static_cast<const std::vector<std::string>&>(words));
}

}  // namespace

void set_option(base::OptionSet& options, const std::string& key, const py::handle& value) {
  if (py::isinstance<py::bool_>(value))
    options.set(key, value.cast<bool>(), where);
  else if (py::isinstance<py::str>(value))
    options.set_text(key, value.cast<std::string>(), where);
  else if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value))
    options.set(key, words_of(value), where);
  else
    options.set(key, number_of(key, value), where);
}

py::object option_of(const base::OptionSet& options, const std::string& key) {
  if (!options.has(key)) throw base::InputError(std::string(where) + ": there is no option '" + key + "'");
  return std::visit([](const auto& value) { return to_python(value); }, options.value(key));
}

py::dict options_dict(const base::OptionSet& options) {
  py::dict all;
  for (const base::OptionSpec& spec : options.specs()) all[py::str(spec.key)] = option_of(options, spec.key);
  return all;
}

}  // namespace foamsim::python
