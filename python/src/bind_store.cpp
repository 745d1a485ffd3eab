#include <fmt/core.h>
#include <pybind11/stl.h>

#include <unistd.h>

#include <variant>

#include "calls.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/dem/engine.hpp"
#include "keywords.hpp"
#include "module.hpp"
#include "report/film_text.hpp"
#include "report/page.hpp"
#include "report/summary/summary.hpp"
#include "result.hpp"
#include "running_stage.hpp"
#include "workflow/export_result.hpp"
#include "workflow/make_packing.hpp"
#include "workflow/run.hpp"
#include "workflow/stage_keys.hpp"

/// Results as folders, files and pages, and single stages of a run.
namespace arenite::python {
namespace {

Numbers numbers_of(const Result& r) {
  return r.films.empty() ? report::Summary(r.run).numbers() : report::film_numbers(r.films.back());
}

/// Tells of the share of all stages.
workflow::RunOptions run_options(Call& call, const Progress& progress) {
  workflow::RunOptions options;
  options.progress = [&](const workflow::Progress& p) {
    call.tell(progress, (static_cast<double>(p.stage) + p.share) / static_cast<double>(p.stages), p.name);
  };
  options.asked_to_stop = [&] { return call.asked_to_stop(); };
  options.notice = [&](const std::string& sentence) { call.warn(sentence); };
  return options;
}

Result run(recipe::Recipe recipe, const Path& out, int threads, const Progress& progress, const OnStep& on_step,
           std::int64_t every) {
  recipe.integration.threads = threads_given(threads);
  Call call;
  const auto steps = step_function(call, on_step, every);
  call.without_lock([&] {
    workflow::RunOptions options = run_options(call, progress);
    options.out = out;
    options.on_step = steps ? &*steps : nullptr;
    return workflow::run(recipe, options);
  });
  return call.without_lock([&] { return open_result(out); });
}

std::vector<std::string> names_of(const std::vector<Path>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.string());
  return names;
}

const io::ExportFormat& format_of(const std::string& name) {
  if (const auto* format = io::export_named(name)) return *format;
  throw refusal("format \"{}\" is not known; there are {}", name, list_of(io::export_names()));
}

/// A folder that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "arenite-XXXXXX").string();
    if (!::mkdtemp(name.data()))
      throw InputError("no temporary folder can be created; set TMPDIR to a writable folder");
    path_ = name;
  }
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  const Path& path() const { return path_; }

 private:
  Path path_;
};

std::vector<std::string> exported(const py::object& what, const Path& out, const std::string& name, bool last) {
  const auto& format = format_of(name);
  Call call;
  if (py::isinstance<py::str>(what) || py::hasattr(what, "__fspath__")) {
    const auto path = what.cast<Path>();
    return names_of(call.without_lock([&] { return workflow::export_result(path, format, out, last); }));
  }
  const Result result = any_result(what);
  return names_of(call.without_lock([&] {
    const TemporaryFolder folder;
    save(result, folder.path());
    return workflow::export_result(folder.path(), format, out, last);
  }));
}

using recipe::Recipe;

std::size_t stage_number(const Recipe& recipe, const py::object& stage) {
  if (PyIndex_Check(stage.ptr())) {
    const auto k = PyNumber_AsSsize_t(stage.ptr(), nullptr);
    if (k >= 0 && static_cast<std::size_t>(k) < recipe.stages.size()) return static_cast<std::size_t>(k);
    throw InputError(fmt::format("there is no stage {}; the recipe has {}, counted from 0", k, recipe.stages.size()));
  }
  if (!py::isinstance<py::str>(stage))
    throw InputError(
        fmt::format("stage is of type {}; give its name, or its number from 0", Py_TYPE(stage.ptr())->tp_name));
  const auto name = stage.cast<std::string>();
  for (std::size_t k = 0; k < recipe.stages.size(); ++k)
    if (recipe.stages[k].name == name) return k;
  std::string known;
  for (const auto& each : recipe.stages) known += (known.empty() ? "" : ", ") + each.name;
  throw InputError(fmt::format("the recipe has no stage \"{}\"; there are {}", name, known));
}

template <int D>
StageResultIn<D> load_stage(const PackingIn<D>& packing, Recipe recipe, const py::object& stage, int threads,
                            const Progress& progress, const OnStep& on_step, std::int64_t every) {
  if (recipe.dimension != D)
    throw refusal("the packing is of {}, and the recipe has dimension = {}; give those that go together",
                  D == 2 ? "disks" : "spheres", recipe.dimension);
  const std::size_t place = stage_number(recipe, stage) + 1;
  recipe.integration.threads = threads_given(threads);
  Call call;
  const auto steps = step_function(call, on_step, every);
  workflow::RunOptions options = run_options(call, progress);
  return call.without_lock([&]() -> StageResultIn<D> {
    dem::EngineIn<D> engine(packing, recipe.contact, recipe.integration);
    auto loaded = workflow::load_stage<D>(
        {recipe, place, workflow::stage_key(recipe, place, dem::save_sample<D>(engine)), &packing}, engine, {}, options,
        {.stages = 1, .name = recipe.stages[place - 1].name}, steps ? &*steps : nullptr);
    return loaded ? std::move(*loaded) : StageResultIn<D>{};
  });
}

void bind_result(py::module_& m) {
  py::class_<Result>(m, "Result", "Contents of a folder or file of results, or parts computed separately.")
      .def(py::init(&result_of), py::arg("stages") = std::vector<StageResult>{},
           py::arg("fields") = std::vector<FieldResult>{}, py::arg("films") = std::vector<FilmResult>{},
           py::arg("voxels") = std::vector<VoxelResult>{}, py::arg("spheres") = std::vector<SphereResult>{},
           py::kw_only(), py::arg("title") = "",
           "Parts (copied) as one result, for figures, `save`, `page` and `export`.")
      .def_readonly("path", &Result::path, "Path it was read from; empty if assembled from parts.")
      .def_readonly("title", &Result::title, "Title of the recipe.")
      .def_property_readonly(
          "converged", [](const Result& r) { return r.run.converged; }, "Every part reached its equilibrium.")
      .def_property_readonly(
          "stages", [](const Result& r) -> const std::vector<StageResult>& { return r.run.stages; },
          "Packing first, then the stages of loading.")
      .def_property_readonly(
          "fields", [](const Result& r) -> const std::vector<FieldResult>& { return r.run.fields; },
          "The cemented sample and its loads.")
      .def_readonly("films", &Result::films, "Results of films.")
      .def_property_readonly(
          "voxels", [](const Result& r) -> const std::vector<VoxelResult>& { return r.run.voxels; },
          "Samples in space under load.")
      .def_property_readonly(
          "spheres", [](const Result& r) -> const std::vector<SphereResult>& { return r.run.spheres; },
          "Packing of spheres first, then the stages of loading, of a recipe with dimension = 3.")
      .def_property_readonly(
          "numbers", [](const Result& r) { return to_python(numbers_of(r)); },
          "As `arenite show --json` prints them; the end of a name is its unit.")
      .def_property_readonly(
          "meanings",
          [](const Result& r) {
            py::dict meanings;
            const Numbers numbers = numbers_of(r);
            for (const auto& [name, number, meaning] : named_numbers(numbers))
              if (meaning) meanings[py::str(name)] = py::make_tuple(meaning->unit, meaning->sentence);
            return meanings;
          },
          "Unit and sentence of each number by its dotted name, {\"texture.solid_fraction\": (\"\", \"Solid fraction, "
          "area of grains over area of the sample\"), ...}.")
      .def("__repr__", [](const Result& r) {
        return fmt::format("<arenite.Result {}: {} stages, {} fields, {} films>", r.path.empty() ? r.title : r.path,
                           r.run.stages.size() + r.run.spheres.size(), r.run.fields.size() + r.run.voxels.size(),
                           r.films.size());
      });
}

void bind_files(py::module_& m) {
  m.def(
      "open",
      [](const Path& path) {
        Call call;
        return call.without_lock([&] { return open_result(path); });
      },
      py::arg("path"), "Reads a run's folder, or one file of it.");
  m.def("run", &run, py::arg("recipe"), py::arg("out"), py::kw_only(), threads_argument(),
        py::arg("progress") = py::none(), py::arg("on_step") = py::none(), py::arg("every") = 1000,
        "Runs a recipe: packing, loading stage by stage, cement, grid, loads. Stages already in `out` are not computed "
        "again. `progress(share, name)` is called meanwhile, and `on_step(stage)` as by `load_stage`, in each stage of "
        "loading that is computed. A stage that it changes, and what comes after it, is computed anew by another run.");
  m.def(
      "save",
      [](const py::object& what, const Path& folder) {
        const Result result = any_result(what);
        Call call;
        return names_of(call.without_lock([&] { return save(result, folder); }));
      },
      py::arg("result"), py::arg("folder"),
      "Stores a Result, Stage, Field, FilmResult, VoxelResult, SphereStage or Packing as result files in a folder, "
      "which `open`, "
      "`arenite show`, "
      "`arenite export` and `arenite figures` read; returns the files. Other results in the folder are moved to "
      "earlier/.");
  m.def("export", &exported, py::arg("result"), py::arg("folder"), py::arg("format") = "vtk", py::kw_only(),
        py::arg("last") = false,
        "Writes a result (its folder or file, a Result, Stage, Field, FilmResult, VoxelResult, SphereStage or Packing) "
        "as `arenite export` does, in one of the formats in docs/formats.md; returns the files. `last`: the last state "
        "only.");
  m.def(
      "page",
      [](const py::object& what, const Path& file) {
        const Result result = any_result(what);
        Call call;
        call.without_lock([&] {
          const auto& stages = result.run.stages.empty() ? result.companion : result.run.stages;
          report::write_page(file, {.title = result.title,
                                    .stages = stages,
                                    .fields = result.run.fields,
                                    .films = result.films,
                                    .voxels = result.run.voxels,
                                    .spheres = result.run.spheres,
                                    .measured = &result.run.measured});
          return 0;
        });
      },
      py::arg("result"), py::arg("file"),
      "Writes the page (self-contained HTML) of a Result, Stage, Field, FilmResult, VoxelResult, SphereStage or "
      "Packing, or of a folder of results.");
}

}  // namespace

void bind_store(py::module_& m) {
  bind_result(m);
  bind_files(m);
}

void bind_stages(py::module_& m) {
  m.def(
      "pack",
      [](const Recipe& recipe) {
        Call call;
        return call.without_lock([&]() -> std::variant<Packing, PackingIn<3>> {
          if (recipe.dimension == 3) return workflow::make_sphere_packing(recipe).snapshots.back().packing;
          return workflow::make_packing(recipe).snapshots.back().packing;
        });
      },
      py::arg("recipe"),
      "The grains in their container before any loading: drawn, placed and relaxed, or read from a file ([packing] of "
      "the recipe): a Packing, or with dimension = 3 a SpherePacking.");
  const auto bind_load_stage = [&](auto load, const char* sentence) {
    m.def("load_stage", load, py::arg("packing"), py::arg("recipe"), py::arg("stage") = 0, py::kw_only(),
          threads_argument(), py::arg("progress") = py::none(), py::arg("on_step") = py::none(),
          py::arg("every") = 1000, sentence);
  };
  bind_load_stage(
      &load_stage<2>,
      "Takes a packing through one stage of the recipe, by number or name: compaction or loading by discrete "
      "elements. `progress(share, name)` is called meanwhile. Velocities are kept, the contact history is not. "
      "`on_step(stage)` is called every so many steps, counted up to the next multiple of 200, with a RunningStage, "
      "which it may read, change and stop; what it raises ends the stage.");
  bind_load_stage(&load_stage<3>, "The same of spheres.");
}

}  // namespace arenite::python
