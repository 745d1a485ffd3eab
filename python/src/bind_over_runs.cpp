#include <pybind11/stl.h>

#include "any_tests.hpp"
#include "arrays.hpp"
#include "calls.hpp"
#include "campaign/study_kind.hpp"
#include "columns.hpp"
#include "grains/fields/driven.hpp"
#include "grains/fields/flow_laws.hpp"
#include "grains/fields/over_runs.hpp"
#include "module.hpp"
#include "recipe/settings.hpp"

/// Curves over several results, and the laws that are fitted to them.
namespace arenite::python {
namespace {

using Stages = std::vector<AnyStage>;
using Befores = std::vector<const Packing*>;

template <statistics::Columns (*curves)(const std::vector<fields::AnyTest>&)>
void bind_over_tests(py::module_& m, const char* name, const char* doc) {
  m.def(
      name,
      [](const Stages& stages, const Befores& before) {
        Call call;
        return to_python(call.without_lock([&] { return curves(any_tests(stages, before)); }));
      },
      py::arg("stages"), py::arg("before"), doc);
}

template <statistics::Columns (*curves)(const std::vector<fields::AnyTest>&)>
void bind_over_stages(py::module_& m, const char* name, const char* doc) {
  m.def(
      name,
      [](const Stages& stages) {
        Call call;
        return to_python(call.without_lock([&] { return curves(any_tests(stages, Befores(stages.size()))); }));
      },
      py::arg("stages"), doc);
}

py::dict power_law(const statistics::PowerLaw& law) {
  py::dict d;
  d["factor"] = to_python(law.factor);
  d["exponent"] = to_python(law.exponent);
  return d;
}

py::dict beverloo(const ArrayLike& opening, const ArrayLike& rate, const ArrayLike& error,
                  std::optional<double> exponent) {
  const auto law =
      fields::fit_beverloo(to_vector(opening, "opening"), to_vector(rate, "rate"), to_vector(error, "error"), exponent);
  py::dict d;
  d["factor"] = to_python(law.factor);
  d["lost_width"] = to_python(law.lost_width);
  if (!exponent) d["exponent"] = to_python(law.exponent);
  return d;
}

py::dict runout(const ArrayLike& aspect_ratio, const ArrayLike& way, double low, double high) {
  const auto laws = fields::fit_runout(to_vector(aspect_ratio, "aspect_ratio"), to_vector(way, "runout"), low, high);
  py::dict d;
  if (laws.low) d["low"] = power_law(*laws.low);
  if (laws.high) d["high"] = power_law(*laws.high);
  return d;
}

py::dict janssen(const ArrayLike& height, const ArrayLike& pressure, const ArrayLike& error,
                 const ArrayLike& hydrostatic) {
  const auto law = fields::fit_janssen(to_vector(height, "height"), to_vector(pressure, "pressure"),
                                       to_vector(error, "error"), to_vector(hydrostatic, "hydrostatic"));
  py::dict d;
  d["saturation"] = to_python(law.saturation);
  d["length"] = to_python(law.length);
  return d;
}

py::dict study_kind(const Path& study) {
  Call call;
  const auto found = call.without_lock([&] { return campaign::kind_of_study(study); });
  py::list driven;
  for (const Path& run : found.driven) driven.append(run.string());
  py::dict d;
  d["driven"] = driven;
  d["flow"] = found.flow.empty() ? py::object(py::none()) : py::object(py::str(found.flow));
  d["figures"] = found.figures();
  return d;
}

void bind_laws(py::module_& m) {
  m.def("fit_beverloo", &beverloo, py::arg("opening"), py::arg("rate"), py::arg("error"), py::kw_only(),
        py::arg("exponent") = py::none(),
        "W = factor (D - lost_width)^exponent of rates of discharge (kg/s) through openings (m), each (value, error); "
        "without the exponent where one is given.");
  m.def(
      "fit_power",
      [](const ArrayLike& x, const ArrayLike& y, const ArrayLike& error) {
        return power_law(statistics::fit_power(to_vector(x, "x"), to_vector(y, "y"), to_vector(error, "error")));
      },
      py::arg("x"), py::arg("y"), py::arg("error"), "y = factor x^exponent by least squares, each (value, error).");
  m.attr("_runout_bend") = fields::runout_bend;
  m.def("fit_runout", &runout, py::arg("aspect_ratio"), py::arg("runout"), py::kw_only(),
        py::arg("low") = fields::runout_bend, py::arg("high") = fields::runout_bend,
        "Power laws of run-outs below and above aspect ratios, low and high, where three points are there.");
  m.def("fit_janssen", &janssen, py::arg("height"), py::arg("pressure"), py::arg("error"), py::arg("hydrostatic"),
        "p = saturation (1 - exp(-H/length)) of pressures (Pa) under fillings (m), each (value, error).");
  m.def(
      "_gravity_of", [](const StageResult& stage) { return fields::gravity_size(stage.asked); }, py::arg("stage"),
      "Acceleration of gravity that a stage was asked for, m/s^2; NaN where it is not known.");
  m.def(
      "length_by_stresses",
      [](const ArrayLike& width, const ArrayLike& wall_friction, const ArrayLike& ratio) {
        return to_python(fields::length_by_stresses(
            to_vector(width, "width"), to_vector(wall_friction, "wall_friction"), to_vector(ratio, "ratio")));
      },
      py::arg("width"), py::arg("wall_friction"), py::arg("ratio"),
      "Janssen's length W/(2 mu_w K), m, mean of the taller half of the silos: (value, error).");
  m.def(
      "steady_ratio",
      [](const ArrayLike& shear, const ArrayLike& normal) {
        return to_python(fields::steady_ratio(finite_numbers(shear, "shear"), finite_numbers(normal, "normal")));
      },
      py::arg("shear"), py::arg("normal"),
      "(ratio of the means, its error) of two stresses over the part in which their ratio is steady.");
}

}  // namespace

void bind_over_runs(py::module_& m) {
  bind_over_tests<fields::rheology>(
      m, "rheology",
      "mu(I) and phi(I) of stages, {name: (values, errors or None, unit, meaning)} in the order of I; `before`: the "
      "packing before each, or None (`arenite.curves.rheology`).");
  bind_over_tests<fields::critical_states>(
      m, "critical_states",
      "Plateaus of stages against the grains' friction, as `rheology` (`arenite.flows.critical_states`).");
  bind_over_stages<fields::discharges>(m, "discharges", "Discharge of stages against opening (`arenite.flows`).");
  bind_over_stages<fields::runouts>(m, "runouts", "Run-out of collapses against aspect ratio (`arenite.flows`).");
  bind_over_stages<fields::silos>(m, "silos", "Pressure on the floor of silos against filling (`arenite.flows`).");
  bind_laws(m);
  m.def("study_kind", &study_kind, py::arg("study"),
        "What the runs of a study are by the last stage of their recipes: driven, the folders of runs that all strain "
        "their sample at a rate; flow: \"beverloo\", \"runout\", \"janssen\", \"critical-state\" or "
        "None; figures: ids of those over runs that suit them.");
  m.def(
      "settings", [](const std::string& recipe) { return recipe::settings_of(recipe); }, py::arg("recipe"),
      "[(key, value)] of a recipe in a result's provenance, as text; keys with dots, items of lists counted from 0. Of "
      "one that this version reads with all its defaults.");
}

}  // namespace arenite::python
