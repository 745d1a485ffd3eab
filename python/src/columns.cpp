#include "columns.hpp"

#include <utility>

#include "arrays.hpp"

namespace arenite::python {

py::dict to_python(statistics::Columns&& columns) {
  py::dict d;
  for (auto& [name, meaning, values, error, tells_errors] : columns.list) {
    const py::object errors = tells_errors ? py::object(taken_over(std::move(error))) : py::object(py::none());
    d[py::str(name)] = py::make_tuple(taken_over(std::move(values)), errors, meaning.unit.empty() ? "1" : meaning.unit,
                                      meaning.sentence);
  }
  return d;
}

py::tuple to_python(const statistics::Estimate& estimate) { return py::make_tuple(estimate.value, estimate.error); }

py::dict columns_of(const History& history, const py::object& self) {
  py::dict d;
  for (const auto& column : history.columns) d[py::str(column.name)] = view(column.values, self);
  return d;
}

}  // namespace arenite::python
