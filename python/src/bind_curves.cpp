#include <pybind11/stl.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "arrays.hpp"
#include "calls.hpp"
#include "columns.hpp"
#include "core/problems.hpp"
#include "grains/fields/laboratory/curves_in_space.hpp"
#include "grains/fields/laboratory/tested_stage.hpp"
#include "grains/fields/state_curves.hpp"
#include "grains/fields/test_curves.hpp"
#include "grains/packing/population.hpp"
#include "module.hpp"
#include "recipe/recipe.hpp"

namespace arenite::python {
namespace {

py::dict curve_of(packing::SizeCurve&& curve) {
  py::dict d;
  d["diameter"] = taken_over(std::move(curve.diameter));
  d["passing"] = taken_over(std::move(curve.passing));
  return d;
}

py::object critical_state(const StageResult& stage, const Packing* before) {
  Call call;
  const Numbers found = call.without_lock([&]() -> Numbers {
    const auto curves = fields::test_curves(fields::Test{stage, before});
    const auto state = curves ? fields::critical_state(*curves) : std::nullopt;
    return state ? fields::numbers_of(*curves, *state) : Numbers();
  });
  return found.is_known() ? py::object(to_python(found)) : py::none();
}

statistics::Columns curves_along(const StageResult& stage, const Packing* before) {
  auto of = fields::loading_of({stage, before});
  if (!of) throw refusal("the stage {} has no history of its sides, so that it has no curves", stage.name);
  return std::move(of->curves);
}

/// One function for each kind of curves of a test.
template <statistics::Columns (*curves)(const StageResult&, const Packing*)>
void bind_curves_of_test(py::module_& m, const char* name, const char* doc) {
  m.def(
      name,
      [](const StageResult& stage, const Packing* before) {
        Call call;
        return to_python(call.without_lock([&] { return curves(stage, before); }));
      },
      py::arg("stage"), py::arg("before") = py::none(), doc);
}

template <statistics::Columns (*curves)(const fields::Test&)>
statistics::Columns of_test(const StageResult& stage, const Packing* before) {
  return curves({stage, before});
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
  constexpr const char* place =
      "Place of the stage of this name, or of the last one, that has a history and states. Raises ValueError if there "
      "is none.";
  using Name = const std::optional<std::string>&;
  m.def("stage_with_history",
        py::overload_cast<const std::vector<const StageResult*>&, Name>(&fields::stage_with_history), py::arg("stages"),
        py::arg("name") = py::none(), place);
  m.def("stage_with_history",
        py::overload_cast<const std::vector<const SphereResult*>&, Name>(&fields::stage_with_history),
        py::arg("stages"), py::arg("name") = py::none(), place);
  m.def("whole_cycles", &fields::whole_cycles, py::arg("stage"),
        "{number: (place of the maximum, place of the minimum)} of the stored states of whole load cycles.");
  bind_curves_of_test<curves_along>(
      m, "curves_along",
      "Curves of a test row by row of its history, {name: (values, errors or None, unit, meaning)}; `before`: the "
      "packing "
      "that strains refer to, the first row without one. `arenite.curves.along` lists them.");
  m.def(
      "curves_along",
      [](const SphereResult& stage, const py::object&) {
        Call call;
        return to_python(call.without_lock([&] { return fields::curves_in_space(stage); }));
      },
      py::arg("stage"), py::arg("before") = py::none(),
      "The same of a stage of spheres; strains refer to the first row.");
  bind_curves_of_test<of_test<fields::curves_of_states>>(
      m, "curves_of_states", "The same over the stored states, with their fabric (`arenite.curves.of_states`).");
  m.def(
      "curves_of_states",
      [](const SphereResult& stage, const py::object&) {
        Call call;
        return to_python(call.without_lock([&] { return fields::states_in_space(stage); }));
      },
      py::arg("stage"), py::arg("before") = py::none(), "The same of a stage of spheres.");
  bind_curves_of_test<of_test<fields::curves_of_cycles>>(
      m, "curves_of_cycles", "The same over cycles of load, of stored states (`arenite.curves.of_cycles`).");
  bind_curves_of_test<of_test<fields::every_cycle>>(
      m, "curves_of_every_cycle", "The same over every cycle, stored or not (`arenite.curves.every_cycle`).");
  m.def("critical_state", &critical_state, py::arg("stage"), py::arg("before") = py::none(),
        "The critical state of a test: `strain` (its name), `from` and `to`, and value, error, low_95 and high_95 of "
        "`mu` (shear over normal stress on the sides) or `q_over_p`, and of `solid_fraction`; None if the ratio does "
        "not settle.");
}

}  // namespace arenite::python
