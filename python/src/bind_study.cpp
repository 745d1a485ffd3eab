#include <pybind11/stl.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>

#include "arrays.hpp"
#include "calls.hpp"
#include "campaign/collect.hpp"
#include "campaign/run_study.hpp"
#include "core/mapped.hpp"
#include "io/table/table.hpp"
#include "keywords.hpp"
#include "model/result.hpp"
#include "module.hpp"
#include "report/film_text.hpp"
#include "report/study/study_page.hpp"
#include "report/summary/summary.hpp"
#include "statistics/difference.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::python {
namespace {

namespace fs = std::filesystem;

/// In the order of statistics::Verdict.
constexpr const char* verdicts[] = {"beyond errors", "within errors", "equal", "no errors given", "in one only"};

/// Numbers where all cells are numbers (NaN where empty), the words otherwise.
py::object swept_column(const campaign::CollectedTable& table, std::size_t k) {
  std::vector<double> numbers;
  py::list words;
  bool all_numbers = true;
  const std::string& unit = table.keys[k].unit;
  for (const auto& row : table.rows) {
    const auto number = io::to_number(row.values[k]);
    all_numbers = all_numbers && (number || row.values[k].empty());
    numbers.push_back(!number ? NAN : unit.empty() ? *number : parse_quantity(row.values[k] + " " + unit).value);
    words.append(row.values[k]);
  }
  if (all_numbers) return taken_over(std::move(numbers));
  return words;
}

template <class Value> py::object by_row(const campaign::CollectedTable& table, Value value) {
  py::list list;
  for (const auto& row : table.rows) list.append(value(row));
  return list;
}

/// The columns of the CSV by the CSV's names: swept keys, numbers, and "NAME_error" where any run has an error. Where a
/// number is itself called so ("beta_error" beside "beta"), the error of the column before it is kept.
py::dict columns_of_table(const campaign::CollectedTable& table) {
  py::dict d;
  if (!table.means) {
    d["run"] = by_row(table, [](const auto& row) { return row.run; });
    d["status"] = by_row(table, [](const auto& row) { return row.status; });
  }
  for (std::size_t k = 0; k < table.keys.size(); ++k) {
    const auto& key = table.keys[k];
    d[py::str(key.name)] = swept_column(table, k);
  }
  if (table.means) d["runs"] = by_row(table, [](const auto& row) { return row.runs; });
  for (std::size_t k = 0; k < table.names.size(); ++k) {
    const auto numbers = mapped(table.rows, [&](const auto& row) { return row.numbers[k]; });
    auto values = mapped(numbers, &statistics::Estimate::value), errors = mapped(numbers, &statistics::Estimate::error);
    const bool any_error = std::any_of(errors.begin(), errors.end(), [](double error) { return std::isfinite(error); });
    if (!d.contains(table.names[k].c_str())) d[py::str(table.names[k])] = taken_over(std::move(values));
    if (any_error) d[py::str(table.names[k] + "_error")] = taken_over(std::move(errors));
  }
  return d;
}

/// Makes the folder, and takes it away again if the study cannot be read and nothing is in it.
campaign::Study study_in(const Path& recipe, const Path& out) {
  const bool was_there = fs::exists(out);
  workflow::make_folder(out);
  try {
    return campaign::read_study(recipe.string(), {}, out);
  } catch (const InputError&) {
    std::error_code ignored;
    if (!was_there) fs::remove(out, ignored);
    throw;
  }
}

Numbers numbers_of_part(const py::object& part) {
  if (py::isinstance<StageResult>(part)) return part.cast<const StageResult&>().texture;
  if (py::isinstance<FieldResult>(part)) return part.cast<const FieldResult&>().numbers;
  if (py::isinstance<VoxelResult>(part)) return part.cast<const VoxelResult&>().numbers;
  if (py::isinstance<FilmResult>(part)) return report::film_numbers(part.cast<const FilmResult&>());
  return Numbers::tree();
}

py::dict periods_of(const py::object& part) {
  const Numbers numbers = numbers_of_part(part);
  py::dict periods;
  for (const auto& [name, estimate, meaning] : campaign::flat_numbers(numbers))
    if (meaning && meaning->period > 0) periods[py::str(name)] = meaning->period;
  return periods;
}

const Keywords& job_keywords() {
  static const Keywords keywords(recipe::every_key<campaign::Jobs>(), {{"jobs", "jobs"}});
  return keywords;
}

py::dict ran(const Path& recipe, const Path& out, const Progress& progress, const py::kwargs& more) {
  campaign::Jobs jobs;
  read_keywords(jobs, job_keywords().given("run_study", more));
  Call call;
  const auto outcome = call.without_lock([&] {
    const campaign::Study study = study_in(recipe, out);
    campaign::StudyOptions options;
    options.jobs = jobs.at_once();
    options.numbers = [](const workflow::RunOutcome& run) { return report::Summary(run).numbers(); };
    options.film_numbers = report::film_numbers;
    options.progress = [&](const campaign::StudyProgress& p) {
      call.tell(progress,
                static_cast<double>(p.done + p.not_done) / static_cast<double>(std::max<std::size_t>(p.runs, 1)),
                "runs");
    };
    options.asked_to_stop = [&] { return call.asked_to_stop(); };
    options.notice = [&](const std::string& sentence) { call.warn(sentence); };
    return campaign::run_study(study, campaign::StudyFolder(out), options);
  });
  py::dict d;
  d["done"] = outcome.done;
  d["not_done"] = outcome.not_done;
  d["left"] = outcome.left;
  return d;
}

}  // namespace

void bind_study(py::module_& m) {
  m.def(
      "study_table",
      [](const Path& recipe, const Path& out, const std::vector<std::string>& by) {
        if (!fs::exists(out)) throw InputError(out.string(), 0, "there is no such folder; run_study creates it");
        const campaign::Study study = campaign::read_study(recipe.string(), {}, out);
        auto table = campaign::collect(study, campaign::StudyFolder(out));
        if (!by.empty()) table = campaign::averaged(table, by);
        return columns_of_table(table);
      },
      py::arg("recipe"), py::arg("out"), py::arg("by") = std::vector<std::string>{},
      "The runs of a study as columns, by the names that `arenite study collect` gives them, without units: run, "
      "status, swept keys (numbers where they are, in SI: \"container.width\" in m), then all numbers of `arenite show "
      "--json` by dotted names, with \"NAME_error\"; NaN if a run has none. `by`: means over runs with equal values of "
      "these keys, and `runs`, their number.");
  m.def(
      "_study_figures", [](const Path& page) { return to_python(report::figures_on(page)); }, py::arg("page"),
      "Contents of the page of a study, from the numbers that `arenite study page` writes beside it: its title and its "
      "figures; empty if there are none.");
  m.def(
      "_flat_numbers",
      [](const py::dict& tree) {
        const Numbers numbers = from_python(tree);
        py::dict flat;
        for (const auto& [name, estimate, meaning] : campaign::flat_numbers(numbers))
          flat[py::str(name)] = py::make_tuple(estimate.value, estimate.error);
        return flat;
      },
      py::arg("tree"),
      "{dotted name: (value, error)} of the single numbers of a tree, NaN where there is none; of lists those of at "
      "most "
      "four.");
  m.def("_periods", &periods_of, py::arg("part"),
        "{dotted name: period, degrees} of the angles among the numbers of a Stage, Field, VoxelResult or FilmResult "
        "that are the "
        "same again after a period; of other objects nothing.");
  m.def(
      "_difference",
      [](double a, double a_error, double b, double b_error, double period) {
        const auto d = statistics::difference_of({a, a_error}, {b, b_error}, period);
        return py::make_tuple(d.value, d.error, d.in_errors, verdicts[static_cast<std::size_t>(d.verdict)]);
      },
      py::arg("a"), py::arg("a_error"), py::arg("b"), py::arg("b_error"), py::arg("period") = 0.0,
      "(b - a, its error, the one over the other, verdict) of two numbers; of angles with a period the shorter way.");
  m.attr("_verdicts") = std::vector<std::string>(std::begin(verdicts), std::end(verdicts));
  m.attr("_least_told") = statistics::least_told;
  m.def("_beyond_by_chance", &statistics::beyond_by_chance, py::arg("judged"),
        "How many of so many differences of equal samples are beyond their errors by chance.");
  m.def(
      "_page_of_figures", [](const py::dict& document) { return report::html_of(from_python(document)); },
      py::arg("document"), "HTML of a page with these figures and tables, as report::html_of has it.");
  def_with_keywords(m, "_run_study", &ran, job_keywords(),
                    "Runs a recipe with [sweep], each run in a fork of this process.", py::arg("recipe"),
                    py::arg("out"), py::kw_only(), py::arg("progress") = py::none());
}

}  // namespace arenite::python
