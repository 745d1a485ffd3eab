#pragma once
#include <pybind11/pybind11.h>

#include "statistics/columns.hpp"
#include "statistics/fit_law.hpp"

namespace arenite::python {

/// {name: (values, errors or None, unit, meaning)}; the unit of numbers without one is "1".
pybind11::dict to_python(statistics::Columns&& columns);

/// (value, error).
pybind11::tuple to_python(const statistics::Estimate& estimate);

}  // namespace arenite::python
