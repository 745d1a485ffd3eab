#include <pybind11/stl.h>

#include <algorithm>
#include <ranges>

#include "any_tests.hpp"
#include "arrays.hpp"
#include "calls.hpp"
#include "core/mapped.hpp"
#include "grains/fields/laboratory/test_numbers.hpp"
#include "module.hpp"
#include "recipe/given.hpp"
#include "report/drawn.hpp"
#include "report/field_document.hpp"
#include "report/figure_heads.hpp"
#include "report/figures/comparison.hpp"
#include "report/figures/field_figures.hpp"
#include "report/figures/figure_document.hpp"
#include "report/figures/film_figures.hpp"
#include "report/figures/grains/grain_values.hpp"
#include "report/figures/headlines.hpp"
#include "report/figures/over_runs.hpp"
#include "report/figures/run_figures.hpp"
#include "report/figures/stage_figures.hpp"
#include "report/figures/state_figures.hpp"
#include "report/figures/state_numbers.hpp"
#include "report/figures/test_figures.hpp"
#include "report/page_document.hpp"
#include "report/print/print.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "workflow/film/film_numbers.hpp"

namespace arenite::python {
namespace {

namespace figures = report::figures;

/// A stage of a run and the packing before it; null where there is none.
struct StageOfRun {
  const StageResult& stage;
  const Packing* before = nullptr;
  const Asked* asked = nullptr;  ///< as the first stage with a size law has it
};

Numbers of_state(const StageOfRun& of, const Snapshot& state, const std::vector<const StageResult*>& run) {
  Numbers out = Numbers::tree();
  const StageResult& stage = of.stage;
  const Packing& packing = state.packing;
  const Numbers numbers = figures::state_numbers(stage, state);
  out.update(figures::numbers_of(figures::state_figures(),
                                 figures::StateData{numbers, mapped(packing.materials, &Material::name)},
                                 figures::whole_list));
  out.update(figures::numbers_of(
      figures::stage_figures(),
      figures::StageData{stage, mapped(stage.snapshots, [](const Snapshot& s) { return &s; }), of.before},
      figures::whole_list));
  std::vector<Numbers> textures;
  for (const StageResult* part : run)
    for (const Snapshot& one : part->snapshots) textures.push_back(figures::state_numbers(*part, one, false));
  // Units of grains are those of the run's end, whichever of its states is drawn, as on its page.
  const auto stored =
      std::ranges::find_if(run | std::views::reverse, [](const StageResult* part) { return !part->snapshots.empty(); });
  const auto grains = [&](std::string_view name) {
    const StageResult& last = stored == run.rend() ? stage : **stored;
    return figures::grain_values(last, stored == run.rend() ? state : last.snapshots.back(), name);
  };
  out.update(figures::numbers_of(
      figures::run_figures(),
      figures::RunData{mapped(textures, [](const Numbers& n) { return &n; }), &packing, *of.asked, grains},
      figures::whole_list));
  return out;
}

inference::FilmStresses stresses_of(const FilmResult& film) {
  if (film.packing.grains.size() == 0) return {};
  return inference::film_stresses(film, workflow::texture_of(film, false).per_grain.considered);
}

Numbers of_film(const FilmResult& film) {
  const inference::FilmStresses stresses = stresses_of(film);
  return figures::numbers_of(figures::film_figures(), figures::FilmData{film, stresses}, figures::whole_list);
}

StageOfRun in_run(const StageResult& stage, const py::list& stages) {
  StageOfRun of{stage, nullptr, &stage.asked};
  bool is_before = true;
  for (const py::handle& one : stages) {
    const auto& other = one.cast<const StageResult&>();
    is_before &= &other != &stage;
    if (is_before && !other.snapshots.empty()) of.before = &other.snapshots.back().packing;
    if (of.asked->diameter.empty()) of.asked = &other.asked;
  }
  if (is_before) of.before = nullptr;  // not of this run
  return of;
}

/// Drawings of a figure of several results.
Numbers of_runs(const std::string& id, const std::vector<fields::AnyTest>& tests) {
  return {{"drawings", mapped(figures::figure_over_runs(id).draw(tests), [](const figures::Drawing& drawing) {
             return figures::numbers_of(drawing, figures::whole_list);
           })}};
}

template <class Work> py::dict drawn(Work&& work) {
  Call call;
  return to_python(call.without_lock(work));
}

template <class Part> void def_headlines(py::module_& m) {
  m.def(
      "_headlines",
      [](const Part& part) {
        return to_python(Numbers{{"headlines", figures::numbers_of(figures::headlines_of(part))}});
      },
      py::arg("part"), "What one asks of it first: [words, symbol, dotted name, share].");
}

void bind_words(py::module_& m) {
  m.def(
      "_figure_heads",
      [] {
        Numbers heads = figures::heads_of_parts();
        heads["runs"] =
            mapped(figures::heads_over_runs(), [](const figures::Head& head) { return figures::numbers_of(head); });
        return to_python(heads);
      },
      "What is said of every figure, by the kind of part that it is of: id, name in print, title, caption, choices.");
  m.attr("_notation") = figures::notation;
  m.attr("_drawn") = to_python(report::drawn());
  py::dict print_words;
  const auto print_keys = recipe::every_key<report::Print>();
  for (const char* name : {"formats", "names", "width"})
    print_words[name] = recipe::help_of(recipe::record_at(print_keys, name)) + ".";
  m.attr("_print_words") = print_words;
  m.attr("_print_widths") = py::make_tuple(report::column_width, report::page_width);
  m.def(
      "_compared",
      [](const py::dict& head, const py::list& one, const py::list& other) {
        return to_python(figures::compared(from_python(head), from_python(one), from_python(other)));
      },
      py::arg("head"), py::arg("one"), py::arg("other"),
      "A figure of two results, from the drawings of each: a list of one, or empty where these have not the same "
      "axes.");
}

void bind_drawn_curves(py::module_& m) {
  m.def(
      "_curve_of_stage",
      [](const StageResult& stage, const Packing* before, const std::string& x, const std::string& y) {
        return drawn([&] {
          const auto states = mapped(stage.snapshots, [](const Snapshot& s) { return &s; });
          return Numbers{{"panel", figures::numbers_of(figures::one_against_another({stage, states, before}, x, y),
                                                       figures::whole_list)}};
        });
      },
      py::arg("stage"), py::arg("before"), py::arg("x"), py::arg("y"),
      "A panel of one curve of a test, or column of its history, against another.");
  m.def(
      "_curve_of_stage",
      [](const SphereResult& stage, const std::string& x, const std::string& y) {
        return drawn([&] {
          Numbers panel = Numbers::tree();
          if (const auto found = figures::one_against_another(stage, x, y))
            panel["panel"] = figures::numbers_of(*found, figures::whole_list);
          return panel;
        });
      },
      py::arg("stage"), py::arg("x"), py::arg("y"),
      "The same of a stage of spheres; empty for the \"test\" of one that is none.");
  m.def(
      "_test_of_stage",
      [](const StageResult& stage, const Packing* before) {
        return drawn([&] {
          const fields::Test test{stage, before};
          const fields::TestKind kind = fields::kind_of(test);
          auto first = figures::headlines_of(kind);
          for (auto& one : figures::headlines_of_grains(kind)) first.push_back(std::move(one));
          return Numbers{{"numbers", fields::test_of(test)}, {"headlines", figures::numbers_of(first)}};
        });
      },
      py::arg("stage"), py::arg("before"),
      "What a test says by its history, and what one asks of it and its grains first: [words, symbol, dotted name, "
      "share].");
  def_headlines<FieldResult>(m);
  def_headlines<VoxelResult>(m);
  def_headlines<SphereResult>(m);
  def_headlines<FilmResult>(m);
}

void bind_drawings(py::module_& m) {
  m.def(
      "_figure_of_runs",
      [](const std::string& id, const std::vector<AnyStage>& stages, const std::vector<const Packing*>& before) {
        return drawn([&] { return of_runs(id, any_tests(stages, before)); });
      },
      py::arg("id"), py::arg("stages"), py::arg("before"),
      "What a figure of several results shows, each a stage and the packing before it or None.");
  m.def(
      "_figures_of_state",
      [](const StageResult& stage, const Snapshot& state, const py::list& run, const py::list& stages) {
        std::vector<const StageResult*> parts;
        for (const py::handle& one : run) parts.push_back(&one.cast<const StageResult&>());
        const StageOfRun of = in_run(stage, stages);
        return drawn([&] { return of_state(of, state, parts); });
      },
      py::arg("stage"), py::arg("state"), py::arg("run"), py::arg("stages"),
      "What the figures of a stored state, of its stage and of the run show, by the figures' ids; `run`: stages whose "
      "states make the run, `stages` all stages.");
  m.def(
      "_film_sigma_norm",
      [](const FilmResult& film) {
        Call call;
        auto found = call.without_lock([&] { return stresses_of(film); });
        py::dict d;
        for (auto& source : found.sources) d[py::str(source.source)] = taken_over(std::move(source.sigma_norm));
        return d;
      },
      py::arg("film"),
      "Stress of every grain over its mean by source: film, simulation_peak_to_peak, simulation_state.");
  m.def(
      "_figures_of_part",
      [](const FieldResult& field) {
        return drawn([&] {
          const Numbers densities = report::densities_of(field);
          return figures::numbers_of(figures::field_figures(), figures::FieldData{field, densities},
                                     figures::whole_list);
        });
      },
      py::arg("field"), "What the figures of a field, a sample in space or a film show, by their ids.");
  m.def(
      "_figures_of_part",
      [](const VoxelResult& volume) {
        return drawn([&] {
          const Numbers densities = volume.numbers.value("stress", Numbers::tree());
          return figures::numbers_of(figures::voxel_figures(), figures::FieldData{volume, densities},
                                     figures::whole_list);
        });
      },
      py::arg("volume"));
  m.def(
      "_figures_of_part",
      [](const SphereResult& stage) {
        return drawn([&] { return figures::numbers_of(figures::sphere_figures(), stage, figures::whole_list); });
      },
      py::arg("spheres"));
  m.def(
      "_figures_of_part", [](const FilmResult& film) { return drawn([&] { return of_film(film); }); }, py::arg("film"));
}

}  // namespace

void bind_figures(py::module_& m) {
  bind_words(m);
  bind_drawn_curves(m);
  bind_drawings(m);
}

}  // namespace arenite::python
