#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "grains/packing/population.hpp"
#include "module.hpp"
#include "recipe/recipe.hpp"
#include "report/test_curves.hpp"

namespace arenite::python {
namespace {

py::dict curve_of(packing::SizeCurve&& curve) {
  py::dict d;
  d["diameter"] = taken_over(std::move(curve.diameter));
  d["passing"] = taken_over(std::move(curve.passing));
  return d;
}

py::object critical_state(const StageResult& stage) {
  Call call;
  const Numbers found = call.without_lock([&]() -> Numbers {
    const auto curves = report::test_curves(stage);
    const auto state = curves ? report::critical_state(*curves) : std::nullopt;
    return state ? report::numbers_of(*curves, *state) : Numbers();
  });
  return found.is_known() ? py::object(to_python(found)) : py::none();
}

}  // namespace

void bind_curves(py::module_& m) {
  m.def(
      "size_curve",
      [](const Packing& packing) { return curve_of(packing::measured_size_curve(packing.grains, packing.materials)); },
      py::arg("packing"),
      "Grading curve of the grains: diameter (m, increasing) and passing, the fraction of the mass in grains no wider; "
      "it keeps its value from one point to the next.");
  m.def(
      "asked_size_curve",
      [](const recipe::Recipe& recipe) {
        Call call;
        return curve_of(call.without_lock(
            [&] { return packing::asked_size_curve(recipe.populations, recipe.materials, recipe.packing.grains); }));
      },
      py::arg("recipe"),
      "The same for the size laws of a recipe's populations. Raises ValueError for a recipe without populations.");
  m.def("critical_state", &critical_state, py::arg("stage"),
        "The critical state of a test: `strain` (its name), `from` and `to`, and value, error, low_95 and high_95 of "
        "`mu` (shear over normal stress on the sides) or `q_over_p`, and of `solid_fraction`; None if the ratio does "
        "not settle.");
}

}  // namespace arenite::python
