#include <pybind11/stl.h>

#include <filesystem>

#include "calls.hpp"
#include "module.hpp"
#include "report/summary.hpp"
#include "study/collect.hpp"
#include "study/run_study.hpp"

namespace arenite::python {
namespace {

namespace fs = std::filesystem;

/// Numbers are collected as columns: swept keys as text, statistics as numbers, NaN where a run has none.
py::dict columns_of(const study::CollectedTable& table) {
  py::dict d;
  for (std::size_t k = 0; k < table.keys.size(); ++k) {
    py::list values;
    for (const auto& row : table.rows) values.append(row.values[k]);
    d[py::str(table.keys[k].name)] = values;
  }
  const auto numpy = py::module_::import("numpy");
  for (std::size_t k = 0; k < table.names.size(); ++k) {
    py::list values, errors;
    bool any_error = false;
    for (const auto& row : table.rows) {
      const auto& number = row.numbers[k];
      values.append(number ? number->value : NAN);
      errors.append(number && number->error ? *number->error : NAN);
      any_error = any_error || (number && number->error);
    }
    d[py::str(table.names[k])] = numpy.attr("array")(values);
    if (any_error) d[py::str(table.names[k] + " error")] = numpy.attr("array")(errors);
  }
  return d;
}

}  // namespace

void bind_study(py::module_& m) {
  m.def("study_table", [](const std::string& recipe, const std::string& out, const std::vector<std::string>& by) {
    const study::Study study = study::read_study(recipe, {}, out);
    auto table = study::collect(study, study::StudyFolder(out));
    if (!by.empty()) table = study::averaged(table, by);
    return columns_of(table);
  }, py::arg("recipe"), py::arg("out"), py::arg("by") = std::vector<std::string>{},
        "The runs of a study as columns: swept keys (text), then all numbers of `arenite show --json` by dotted names, \"NAME error\" beside them. `by`: means over runs with equal values of these keys.");
  m.def("_run_study", [](const std::string& recipe, const std::string& out, std::size_t jobs, const py::object& progress) {
    Call call;
    const auto outcome = call.without_lock([&] {
      fs::create_directories(out);
      const study::Study study = study::read_study(recipe, {}, out);
      study::StudyOptions options;
      options.jobs = jobs;
      options.numbers = [](const study::RunOutcome& run) { return report::Summary(run).json(); };
      options.progress = [&](const study::StudyProgress& p) { call.tell(progress, static_cast<double>(p.done + p.not_done) / static_cast<double>(std::max<std::size_t>(p.runs, 1)), "runs"); };
      options.asked_to_stop = [&] { return call.asked_to_stop(); };
      return study::run_study(study, study::StudyFolder(out), options);
    });
    py::dict d;
    d["done"] = outcome.done;
    d["not_done"] = outcome.not_done;
    d["left"] = outcome.left;
    return d;
  }, py::arg("recipe"), py::arg("out"), py::kw_only(), py::arg("jobs") = 1, py::arg("progress") = py::none(),
        "Runs a recipe with [sweep], each run in a process of its own; what was done before is not done again. Gives how many are done, not done, left.");
}

}  // namespace arenite::python
