#include "arguments.hpp"

#include <fmt/core.h>

#include <cmath>

#include "core/error.hpp"
#include "core/unit_names.hpp"

namespace arenite::python {
namespace {

double number_or_text(const Quantity& quantity, Dimension wanted) {
  if (py::isinstance<py::str>(quantity)) return parse_si(quantity.cast<std::string>(), wanted);
  const double value = PyFloat_AsDouble(quantity.ptr());
  if (!PyErr_Occurred()) return value;
  PyErr_Clear();
  const std::string unit = si_unit(wanted);
  throw InputError(fmt::format("is of type {}; give a number{}", Py_TYPE(quantity.ptr())->tp_name,
                               unit.empty() ? "" : fmt::format(" ({}), or text with a unit", unit)));
}

}  // namespace

double Quantity::si(Dimension wanted, const std::string& name) const {
  try {
    const double value = number_or_text(*this, wanted);
    if (!std::isfinite(value)) throw InputError("is not finite; give a number that is");
    return value;
  } catch (const InputError& error) { throw in_file(error, name); }
}

std::optional<double> si(const std::optional<Quantity>& quantity, Dimension wanted, const std::string& name) {
  return quantity ? std::optional(quantity->si(wanted, name)) : std::nullopt;
}

std::vector<double> si(const std::vector<Quantity>& quantities, Dimension wanted, const std::string& name) {
  std::vector<double> values;
  for (const Quantity& each : quantities) values.push_back(each.si(wanted, name));
  return values;
}

std::pair<bool, bool> periodic_directions(const std::string& word) {
  if (word != "" && word != "x" && word != "y" && word != "xy")
    throw InputError(
        fmt::format("periodic is \"{}\"; give \"x\", \"y\", \"xy\", or \"\" for walls on all sides", word));
  return {word.starts_with('x'), word.ends_with('y')};
}

}  // namespace arenite::python
