#pragma once
#include <pybind11/pybind11.h>

#include "model/result.hpp"
#include "statistics/columns.hpp"
#include "statistics/fit_law.hpp"

namespace arenite::python {

/// {name: (values, errors or None, unit, meaning)}; the unit of numbers without one is "1".
pybind11::dict to_python(statistics::Columns&& columns);

/// Columns of a history by name, which look into the result that `self` is.
pybind11::dict columns_of(const History& history, const pybind11::object& self);

/// (value, error).
pybind11::tuple to_python(const statistics::Estimate& estimate);

}  // namespace arenite::python
