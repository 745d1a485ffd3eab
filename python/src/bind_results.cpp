#include <fmt/format.h>
#include <pybind11/stl.h>

#include <filesystem>

#include "arrays.hpp"
#include "calls.hpp"
#include "io/field_file.hpp"
#include "io/film_result_file.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "io/stage_file.hpp"
#include "module.hpp"
#include "report/film_text.hpp"
#include "report/summary.hpp"
#include "study/run.hpp"

namespace arenite::python {
namespace {

/// What a folder or a file of results holds.
struct Result {
  std::string path, title;
  study::RunOutcome run;
  std::vector<FilmResult> films;
};

std::string title_of(const Result& r) {
  for (const auto& stage : r.run.stages) return study::title_in(stage.provenance.recipe);
  for (const auto& field : r.run.fields) return study::title_in(field.provenance.recipe);
  for (const auto& film : r.films) return study::title_in(film.provenance.recipe);
  return {};
}

Result open(const std::string& path) {
  Result r;
  r.path = path;
  r.run.files = io::stage_files(path);
  bool& converged = r.run.converged;
  for (const auto& file : r.run.files) {
    const std::string kind = io::sealed_kind(file);
    if (kind == "field") converged = r.run.fields.emplace_back(io::read_field(file)).converged && converged;
    else if (kind == "film") converged = r.films.emplace_back(io::read_film_result(file)).converged && converged;
    else converged = r.run.stages.emplace_back(io::read_stage(file)).converged && converged;
  }
  r.title = title_of(r);
  return r;
}

std::string numbers_of(const Result& r) { return r.films.empty() ? report::Summary(r.run).json() : report::film_json(r.films.back()); }

Result run(const study::Recipe& recipe, const std::string& out, int threads, const py::object& progress) {
  study::Recipe asked = recipe;
  asked.integration.threads = threads;
  Call call;
  call.without_lock([&] {
    study::RunOptions options;
    options.out = out;
    options.progress = [&](const study::Progress& p) { call.tell(progress, (static_cast<double>(p.stage) + p.share) / static_cast<double>(p.stages), p.name); };
    options.asked_to_stop = [&] { return call.asked_to_stop(); };
    return study::run(asked, options);
  });
  return open(out);
}

py::dict history_of(const History& history) {
  py::dict d;
  for (const auto& column : history.columns) d[py::str(column.name)] = py::array_t<double>(static_cast<py::ssize_t>(column.values.size()), column.values.data());
  return d;
}

py::dict history_units(const History& history) {
  py::dict d;
  for (const auto& column : history.columns) d[py::str(column.name)] = column.unit;
  return d;
}

py::dict provenance_of(const Provenance& p) {
  py::dict d;
  d["version"] = p.version;
  d["stage"] = p.stage;
  d["input_hash"] = p.input_hash;
  d["recipe"] = p.recipe;
  d["seed"] = p.seed;
  d["kernel"] = p.kernel;
  d["options"] = p.options;
  return d;
}

py::dict energies_of(const Frame& frame) {
  py::dict d;
  for (const EnergyTerm& term : energy_terms) d[term.name] = frame.energies.*term.value;
  return d;
}

void bind_stage_results(py::module_& m) {
  py::class_<Frame>(m, "Frame", "One stored state of a stage.")
      .def_readonly("time", &Frame::time, "s since the start of the run.")
      .def_readonly("step", &Frame::step)
      .def_readonly("label", &Frame::label)
      .def_property_readonly("packing", [](const Frame& f) -> const Packing& { return f.packing; }, py::return_value_policy::reference_internal)
      .def_property_readonly("energies", &energies_of, "J.")
      .def_property_readonly("unbalanced_ratio", [](const Frame& f) { return f.equilibrium.unbalanced_ratio; })
      .def_property_readonly("kinetic_ratio", [](const Frame& f) { return f.equilibrium.kinetic_ratio; })
      .def("__repr__", [](const Frame& f) { return "<arenite.Frame \"" + f.label + "\">"; });
  py::class_<StageResult>(m, "Stage", "The result of one stage of packing or loading.")
      .def_readonly("name", &StageResult::name)
      .def_readonly("converged", &StageResult::converged, "Equilibrium was reached in every increment.")
      .def_readonly("outcome", &StageResult::outcome)
      .def_property_readonly("frames", [](const py::object& self) {
        py::list frames;
        for (const auto& frame : self.cast<const StageResult&>().frames) frames.append(py::cast(&frame, py::return_value_policy::reference_internal, self));
        return frames;
      }, "Stored states in time order.")
      .def_property_readonly("packing", [](const StageResult& s) -> const Packing& {
        if (s.frames.empty()) throw InputError("this stage stored no state");
        return s.frames.back().packing;
      }, py::return_value_policy::reference_internal, "The state that is handed on.")
      .def_property_readonly("history", [](const StageResult& s) { return history_of(s.history); }, "Scalars sampled while the stage ran, as arrays by name.")
      .def_property_readonly("history_units", [](const StageResult& s) { return history_units(s.history); })
      .def_property_readonly("texture", [](const StageResult& s) { return from_json(s.texture_json); }, "Texture of the last state, as `measure` gives it.")
      .def_property_readonly("provenance", [](const StageResult& s) { return provenance_of(s.provenance); })
      .def("__repr__", [](const StageResult& s) { return "<arenite.Stage \"" + s.name + "\": " + s.outcome + ">"; });
}

void bind_fields(py::module_& m) {
  py::class_<FieldResult> c(m, "Field", "A cemented sample, or its stresses under load. Arrays are (height, width), the bottom row first.");
  c.def_readonly("name", &FieldResult::name)
      .def_readonly("converged", &FieldResult::converged)
      .def_readonly("outcome", &FieldResult::outcome)
      .def_property_readonly("map", [](const FieldResult& f) -> const PhaseMap& { return f.map; }, py::return_value_policy::reference_internal)
      .def_property_readonly("packing", [](const FieldResult& f) -> const Packing& { return f.packing; }, py::return_value_policy::reference_internal,
                             "What was rasterised, in the map's coordinates; no grains if the map came from a picture.")
      .def_property_readonly("loaded", [](const FieldResult& f) { return f.field.size() > 0; })
      .def_property_readonly("numbers", [](const FieldResult& f) { return from_json(f.numbers_json); }, "Report and statistics.")
      .def_property_readonly("convergence", [](const FieldResult& f) { return history_of(f.convergence); }, "iteration, residual.")
      .def_property_readonly("curve", [](const FieldResult& f) { return history_of(f.curve); },
                             "Of a pull to failure: strain, stress (Pa), work, elastic, released (J/m), broken.")
      .def_property_readonly("cracks", [](const FieldResult& f) {
        const auto n = static_cast<py::ssize_t>(f.cracks.size());
        py::array_t<double> x(n), y(n), strain(n);
        py::array_t<std::uint8_t> type(n);
        for (py::ssize_t k = 0; k < n; ++k) {
          const Crack& crack = f.cracks[static_cast<std::size_t>(k)];
          x.mutable_at(k) = static_cast<double>(crack.x);
          y.mutable_at(k) = static_cast<double>(crack.y);
          strain.mutable_at(k) = crack.strain;
          type.mutable_at(k) = crack.type;
        }
        py::dict d;
        d["x"] = x;
        d["y"] = y;
        d["type"] = type;
        d["strain"] = strain;
        return d;
      }, "Broken bonds in the order of breaking: x, y (m), type (1 matrix, 2 interface, 3 particle), strain of the sample.")
      .def_property_readonly("provenance", [](const FieldResult& f) { return provenance_of(f.provenance); })
      .def("statistics", [](const FieldResult& f, bool curves) {
        Call call;
        return from_json(call.without_lock([&] { return stress::to_json(stress::measure(f.map, f.field), curves); }));
      }, py::kw_only(), py::arg("curves") = true, "Distributions of node stresses by phase (P IV), as a dict.")
      .def("__repr__", [](const FieldResult& f) { return "<arenite.Field \"" + f.name + "\": " + f.outcome + ">"; });
  const auto component = [&c](const char* name, std::vector<double> StressField::* member, const char* doc) {
    c.def_property_readonly(name, [member](const py::object& self) {
      const auto& field = self.cast<const FieldResult&>().field;
      return image_view(field.*member, field.height, field.width, self);
    }, doc);
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
  py::class_<Result>(m, "Result", "What a folder or a file of results holds.")
      .def_readonly("path", &Result::path)
      .def_readonly("title", &Result::title)
      .def_property_readonly("converged", [](const Result& r) { return r.run.converged; })
      .def_property_readonly("stages", [](const Result& r) -> const std::vector<StageResult>& { return r.run.stages; }, "Packing first, then the stages of loading.")
      .def_property_readonly("fields", [](const Result& r) -> const std::vector<FieldResult>& { return r.run.fields; }, "The cemented sample and its loads.")
      .def_readonly("films", &Result::films, "What a film gave.")
      .def_property_readonly("numbers", [](const Result& r) { return from_json(numbers_of(r)); }, "As `arenite show --json` prints them.")
      .def("__repr__", [](const Result& r) {
        return fmt::format("<arenite.Result {}: {} stages, {} fields, {} films>", r.path, r.run.stages.size(), r.run.fields.size(), r.films.size());
      });
  m.def("open", [](const std::string& path) {
    Call call;
    return call.without_lock([&] { return open(path); });
  }, py::arg("path"), "Reads a run's folder, or one file of it.");
  m.def("run", &run, py::arg("recipe"), py::arg("out"), py::kw_only(), py::arg("threads") = 1, py::arg("progress") = py::none(),
        "Runs a recipe: packing, loading stage by stage, cement, raster, loads. What lies in `out` already is not computed again. `progress(share, name)` is called meanwhile.");
}

}  // namespace arenite::python
