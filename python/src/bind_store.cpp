#include <fmt/format.h>
#include <pybind11/stl.h>
#include <unistd.h>

#include "calls.hpp"
#include "core/error.hpp"
#include "module.hpp"
#include "report/film_text.hpp"
#include "report/page.hpp"
#include "report/summary.hpp"
#include "result.hpp"
#include "workflow/export_result.hpp"

/// Results as folders, files and pages.
namespace arenite::python {
namespace {

Numbers numbers_of(const Result& r) { return r.films.empty() ? report::Summary(r.run).numbers() : report::film_numbers(r.films.back()); }

Result run(const study::Recipe& recipe, const Path& out, int threads, const Progress& progress) {
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
  return call.without_lock([&] { return open_result(out); });
}

std::vector<std::string> names_of(const std::vector<Path>& files) {
  std::vector<std::string> names;
  for (const auto& file : files) names.push_back(file.string());
  return names;
}

const io::ExportFormat& format_of(const std::string& name) {
  std::string known;
  for (const auto& format : io::export_formats()) {
    if (name == format.name) return format;
    known += (known.empty() ? "" : ", ") + std::string(format.name);
  }
  throw InputError(fmt::format("format \"{}\" is not known; there are {}", name, known));
}

/// A folder that goes with the object.
class TemporaryFolder {
 public:
  TemporaryFolder() {
    std::string name = (std::filesystem::temp_directory_path() / "arenite-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw InputError("no temporary folder can be made; set TMPDIR to one that can be written to");
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
    return names_of(call.without_lock([&] { return study::export_result(path, format, out, last); }));
  }
  const Result result = any_result(what);
  return names_of(call.without_lock([&] {
    const TemporaryFolder folder;
    save(result, folder.path());
    return study::export_result(folder.path(), format, out, last);
  }));
}

/// The page of these parts, with the texture of every stage's last state.
void write_page(const Result& result, const Path& file) {
  report::PageData data;
  data.title = result.title;
  for (std::size_t s = 0; s < result.run.stages.size(); ++s) {
    const StageResult& stage = result.run.stages[s];
    data.stages.push_back(&stage);
    if (!stage.frames.empty()) data.textures.push_back({s, stage.frames.size() - 1, texture::measure(stage.frames.back().packing)});
  }
  for (const auto& field : result.run.fields) data.fields.push_back({&field});
  for (const auto& film : result.films) data.films.push_back({&film});
  report::write_page(file, data);
}

}  // namespace

void bind_store(py::module_& m) {
  py::class_<Result>(m, "Result", "What a folder or a file of results holds, or parts that were computed one by one.")
      .def(py::init(&result_of), py::arg("stages") = std::vector<StageResult>{}, py::arg("fields") = std::vector<FieldResult>{}, py::arg("films") = std::vector<FilmResult>{},
           py::kw_only(), py::arg("title") = "", "Parts (copied) as one result, for figures, `save`, `page` and `export`.")
      .def_readonly("path", &Result::path, "Where it was read from; empty for parts put together.")
      .def_readonly("title", &Result::title, "Of the recipe.")
      .def_property_readonly("converged", [](const Result& r) { return r.run.converged; }, "Every part reached its equilibrium.")
      .def_property_readonly("stages", [](const Result& r) -> const std::vector<StageResult>& { return r.run.stages; }, "Packing first, then the stages of loading.")
      .def_property_readonly("fields", [](const Result& r) -> const std::vector<FieldResult>& { return r.run.fields; }, "The cemented sample and its loads.")
      .def_readonly("films", &Result::films, "What a film gave.")
      .def_property_readonly("numbers", [](const Result& r) { return to_python(numbers_of(r)); }, "As `arenite show --json` prints them; the end of a name is its unit.")
      .def("__repr__", [](const Result& r) {
        return fmt::format("<arenite.Result {}: {} stages, {} fields, {} films>", r.path.empty() ? r.title : r.path, r.run.stages.size(), r.run.fields.size(), r.films.size());
      });
  m.def("open", [](const Path& path) {
    Call call;
    return call.without_lock([&] { return open_result(path); });
  }, py::arg("path"), "Reads a run's folder, or one file of it.");
  m.def("run", &run, py::arg("recipe"), py::arg("out"), py::kw_only(), py::arg("threads") = 1, py::arg("progress") = py::none(),
        "Runs a recipe: packing, loading stage by stage, cement, raster, loads. What lies in `out` already is not computed again. `progress(share, name)` is called meanwhile.");
  m.def("save", [](const py::object& what, const Path& folder) {
    const Result result = any_result(what);
    Call call;
    return names_of(call.without_lock([&] { return save(result, folder); }));
  }, py::arg("result"), py::arg("folder"),
        "Stores a Result, Stage, Field, FilmResult or Packing as files of the program's own in a folder, which `open`, `arenite show`, `arenite export` and `arenite figures` "
        "read; gives the files. Other results that lie there are put aside, under earlier/.");
  m.def("export", &exported, py::arg("result"), py::arg("folder"), py::arg("format") = "vtk", py::kw_only(), py::arg("last") = false,
        "Writes a result (its folder or file, a Result, Stage, Field, FilmResult or Packing) as `arenite export` does: \"vtk\", \"csv\", \"lammps\" or \"extxyz\"; gives the files. `last`: the "
        "last state only.");
  m.def("page", [](const py::object& what, const Path& file) {
    const Result result = any_result(what);
    Call call;
    call.without_lock([&] { write_page(result, file); return 0; });
  }, py::arg("result"), py::arg("file"), "Writes the page (HTML, all inside) of a Result, Stage, Field, FilmResult or Packing, or of a folder of results.");
}

}  // namespace arenite::python
