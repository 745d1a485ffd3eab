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

}  // namespace arenite::python
