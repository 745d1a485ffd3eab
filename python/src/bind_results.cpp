#include <pybind11/stl.h>

#include <cmath>
#include <tuple>

#include "arrays.hpp"
#include "calls.hpp"
#include "columns.hpp"
#include "core/problems.hpp"
#include "core/version.hpp"
#include "model/result.hpp"
#include "module.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::python {
namespace {

py::dict history_units(const History& history) {
  py::dict d;
  for (const auto& column : history.columns) d[py::str(column.name)] = column.unit;
  return d;
}

py::dict energies_of(const Snapshot& snapshot) {
  py::dict d;
  for (const EnergyTerm& term : energy_terms) d[term.name] = snapshot.energies.*term.value;
  if (snapshot.energies.exchanged != 0) d[exchange_term.name] = snapshot.energies.exchanged;
  return d;
}

using States = std::vector<std::tuple<double, std::string, Packing>>;

/// Columns of one length; their units stay open.
History history_of(const py::dict& columns, const char* name) {
  History history;
  for (const auto& [key, values] : columns) {
    const auto column = py::str(key).cast<std::string>();
    history.columns.push_back({column, "", to_vector(py::reinterpret_borrow<ArrayLike>(values), column)});
    if (history.columns.back().values.size() != history.columns.front().values.size())
      throw refusal("{} has columns of different lengths; \"{}\" has {} rows, and \"{}\" {}", name, column,
                    history.columns.back().values.size(), history.columns.front().name,
                    history.columns.front().values.size());
  }
  return history;
}

Asked asked_from(const py::dict& given) {
  Asked asked;
  asked.known = py::len(given) > 0;
  if (given.contains("friction")) asked.friction = given["friction"].cast<double>();
  if (given.contains("gravity"))
    std::tie(asked.gravity.x, asked.gravity.y) = given["gravity"].cast<std::pair<double, double>>();
  if (given.contains("load_axis"))
    asked.load_axis = given["load_axis"].cast<std::optional<double>>().value_or(statistics::unknown);
  if (given.contains("in_motion")) asked.in_motion = given["in_motion"].cast<bool>();
  if (given.contains("in_equilibrium")) asked.in_equilibrium = given["in_equilibrium"].cast<bool>();
  for (int side = 0; side < sides; ++side) {
    const auto s = static_cast<std::size_t>(side);
    if (given.contains("cycled") && py::str(given["cycled"]).equal(py::str(side_names[s]))) asked.cycled = side;
    if (given.contains("slide") && py::dict(given["slide"]).contains(side_names[s]))
      asked.slide[s] = py::dict(given["slide"])[side_names[s]].cast<double>();
  }
  return asked;
}

py::dict asked_of(const Asked& asked) {
  py::dict d, slide, sizes;
  if (!asked.known) return d;
  for (std::size_t s = 0; s < sides; ++s)
    if (asked.slide[s] != 0) slide[side_names[s]] = asked.slide[s];
  sizes["diameter"] = taken_over(std::vector(asked.diameter));
  sizes["passing"] = taken_over(std::vector(asked.passing));
  d["friction"] = asked.friction;
  d["gravity"] = py::make_tuple(asked.gravity.x, asked.gravity.y);
  d["slide"] = slide;
  d["load_axis"] = std::isfinite(asked.load_axis) ? py::object(py::float_(asked.load_axis)) : py::none();
  d["cycled"] =
      asked.cycled >= 0 ? py::object(py::str(side_names[static_cast<std::size_t>(asked.cycled)])) : py::none();
  d["in_motion"] = asked.in_motion;
  d["in_equilibrium"] = asked.in_equilibrium;
  d["sizes"] = sizes;
  return d;
}

StageResult made_up_stage(const std::string& name, const py::dict& history, const States& states,
                          const py::dict& cycles, const py::dict& texture, const py::dict& asked) {
  StageResult stage;
  stage.name = stage.provenance.stage = name;
  stage.outcome = "made up";
  stage.provenance.version = version;
  stage.history = history_of(history, "history");
  stage.cycles = history_of(cycles, "cycles");
  stage.texture = from_python(texture);
  stage.asked = asked_from(asked);
  for (const auto& [time, label, packing] : states) {
    stage.snapshots.emplace_back();
    stage.snapshots.back().time = time;
    stage.snapshots.back().label = label;
    stage.snapshots.back().packing = packing;
  }
  return stage;
}

void bind_stage_results(py::module_& m) {
  py::class_<Snapshot>(m, "Snapshot", "One stored state of a stage.")
      .def_readonly("time", &Snapshot::time, "s since the start of the run.")
      .def_readonly("step", &Snapshot::step, "Time steps since the start of the run.")
      .def_readonly("label", &Snapshot::label, "\"increment 3 of 10\", \"cycle 2 maximum\".")
      .def_property_readonly(
          "packing", [](const Snapshot& f) -> const Packing& { return f.packing; },
          py::return_value_policy::reference_internal, "Grains and contacts in this state.")
      .def_property_readonly("energies", &energies_of, "By name, J.")
      .def_property_readonly(
          "unbalanced_ratio", [](const Snapshot& f) { return f.equilibrium.unbalanced_ratio; },
          "Mean resultant force on a grain over the mean contact force.")
      .def_property_readonly(
          "kinetic_ratio", [](const Snapshot& f) { return f.equilibrium.kinetic_ratio; },
          "Kinetic over elastic energy.")
      .def("__repr__", [](const Snapshot& f) { return "<arenite.Snapshot \"" + f.label + "\">"; });
  py::class_<StageResult>(m, "Stage", "The result of one stage of packing or loading.")
      .def(py::init(&made_up_stage), py::arg("name"), py::kw_only(), py::arg("history") = py::dict(),
           py::arg("states") = States(), py::arg("cycles") = py::dict(), py::arg("texture") = py::dict(),
           py::arg("asked") = py::dict(),
           "A stage that another program or a model made: `history` and `cycles` of columns by name, SI, of equal "
           "length; `states` of (time, label, packing); `texture`, its stored numbers; `asked`, some of what `asked` "
           "has. `arenite.curves` and `arenite.flows` take it as any other.")
      .def_readonly("name", &StageResult::name, "Name in the recipe.")
      .def_readonly("converged", &StageResult::converged, "Equilibrium was reached in every increment.")
      .def_readonly("outcome", &StageResult::outcome, "Outcome in a sentence.")
      .def_property_readonly(
          "snapshots",
          [](const py::object& self) {
            py::list snapshots;
            for (const auto& snapshot : self.cast<const StageResult&>().snapshots)
              snapshots.append(py::cast(&snapshot, py::return_value_policy::reference_internal, self));
            return snapshots;
          },
          "Stored states in time order.")
      .def_property_readonly(
          "frames", [](const py::object& self) { return self.attr("snapshots"); }, "Former name of `snapshots`.")
      .def_property_readonly(
          "packing",
          [](const StageResult& s) -> const Packing& {
            if (s.snapshots.empty()) throw InputError("this stage stored no state");
            return s.snapshots.back().packing;
          },
          py::return_value_policy::reference_internal, "The final state, passed to the next stage.")
      .def_property_readonly(
          "history", [](const py::object& self) { return columns_of(self.cast<const StageResult&>().history, self); },
          "Scalars sampled while the stage ran, as arrays by name; `history_units` has their units.")
      .def_property_readonly(
          "history_units", [](const StageResult& s) { return history_units(s.history); },
          "Unit of every column of `history`; empty: none.")
      .def_property_readonly(
          "cycles", [](const py::object& self) { return columns_of(self.cast<const StageResult&>().cycles, self); },
          "For a stage with cycles: `cycle` (from 1), `at_maximum` (1 or 0) and the columns of `history` at the end of "
          "each half cycle.")
      .def_property_readonly(
          "texture", [](const StageResult& s) { return to_python(s.texture); },
          "Stored statistics of the last state, without curves; names as in `measure`.")
      .def_property_readonly(
          "asked", [](const StageResult& s) { return asked_of(s.asked); },
          "What the stage was asked for: friction between grains, gravity (m/s^2, at its end), slide "
          "of walls (m/s, as it begins), load_axis (rad or None), cycled (the side that goes to and "
          "fro or None), in_motion, in_equilibrium, sizes (diameter, passing); empty where it is not "
          "known.")
      .def_property_readonly(
          "provenance", [](const StageResult& s) { return to_python(s.provenance); },
          "Provenance: version, stage, input_hash, recipe, seed, kernel, options.")
      .def("__repr__", [](const StageResult& s) { return "<arenite.Stage \"" + s.name + "\": " + s.outcome + ">"; });
}

py::dict cracks_of(const py::object& self) {
  const auto& cracks = self.cast<const FieldResult&>().cracks;
  py::dict d;
  d["x"] = member_view(cracks, &Crack::x, self);
  d["y"] = member_view(cracks, &Crack::y, self);
  d["type"] = member_view(cracks, &Crack::type, self);
  d["strain"] = member_view(cracks, &Crack::strain, self);
  return d;
}

void bind_fields(py::module_& m) {
  py::class_<FieldResult> c(
      m, "Field", "A cemented sample, or its stresses under load. Arrays are (height, width), the bottom row first.");
  c.def_readonly("name", &FieldResult::name, "Name in the recipe.")
      .def_readonly("converged", &FieldResult::converged, "Equilibrium was reached within the tolerance.")
      .def_readonly("outcome", &FieldResult::outcome, "Outcome in a sentence.")
      .def_property_readonly(
          "map", [](const FieldResult& f) -> const PhaseMap& { return f.map; },
          py::return_value_policy::reference_internal, "Phases and grains of the nodes.")
      .def_property_readonly(
          "packing", [](const FieldResult& f) -> const Packing& { return f.packing; },
          py::return_value_policy::reference_internal,
          "The packing that was discretised, in the map's coordinates; no grains if the map came from a picture.")
      .def_property_readonly(
          "loaded", [](const FieldResult& f) { return f.field.size() > 0; },
          "False for a sample that was not loaded and has no stresses.")
      .def_property_readonly(
          "numbers", [](const FieldResult& f) { return to_python(f.numbers); },
          "Report and statistics as `arenite show --json` prints them; the end of a name is its unit.")
      .def_property_readonly(
          "convergence",
          [](const py::object& self) { return columns_of(self.cast<const FieldResult&>().convergence, self); },
          "iteration, residual (relative).")
      .def_property_readonly(
          "curve", [](const py::object& self) { return columns_of(self.cast<const FieldResult&>().curve, self); },
          "Of a test to failure: strain, stress, work, elastic and released energy (per metre of depth), broken bonds; "
          "`curve_units` has their units.")
      .def_property_readonly(
          "curve_units", [](const FieldResult& f) { return history_units(f.curve); },
          "Unit of every column of `curve`; \"1\": none.")
      .def_property_readonly("cracks", &cracks_of,
                             "Broken bonds in the order of breaking: x, y (m, float32), type (1 matrix, 2 interface, 3 "
                             "particle), strain of the sample.")
      .def_property_readonly(
          "provenance", [](const FieldResult& f) { return to_python(f.provenance); },
          "Provenance: version, stage, input_hash, recipe, seed, kernel, options.")
      .def(
          "statistics",
          [](const FieldResult& f, bool curves) {
            Call call;
            stress::StressOptions options;
            options.components = {stress::Component::yy, stress::Component::xx, stress::Component::xy,
                                  stress::Component::hydrostatic};
            return to_arrays(
                call.without_lock([&] { return stress::numbers(stress::measure(f.map, f.field, options), curves); }));
          },
          py::kw_only(), py::arg("curves") = true,
          "Distributions of node stresses by phase (P IV) as a dict: by component (sigma_yy, sigma_xx, sigma_xy, "
          "sigma_hyd) and set, each statistic {\"value\", \"error\"}; the end of a name is its unit (_Pa); all others "
          "are relative to the mean of the sample or of the set.")
      .def("__repr__", [](const FieldResult& f) { return "<arenite.Field \"" + f.name + "\": " + f.outcome + ">"; });
  const auto component = [&c](const char* name, std::vector<double> StressField::*member, const char* doc) {
    c.def_property_readonly(
        name,
        [member](const py::object& self) {
          const auto& field = self.cast<const FieldResult&>().field;
          return image_view(field.*member, field.height, field.width, self);
        },
        doc);
  };
  component("sigma_xx", &StressField::xx, "Pa, tension positive.");
  component("sigma_yy", &StressField::yy, "Pa, tension positive.");
  component("sigma_xy", &StressField::xy, "Pa.");
  component("ux", &StressField::ux, "Displacement, m.");
  component("uy", &StressField::uy, "Displacement, m.");
}

}  // namespace

void bind_results(py::module_& m) {
  bind_stage_results(m);
  bind_fields(m);
}

}  // namespace arenite::python
