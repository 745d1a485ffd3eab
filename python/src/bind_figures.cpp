#include <pybind11/stl.h>

#include "arrays.hpp"
#include "calls.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/fields/coarse_layers.hpp"
#include "grains/fields/laboratory/test_numbers.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/texture/grain_quantities.hpp"
#include "grains/texture/texture.hpp"
#include "module.hpp"
#include "report/field_document.hpp"
#include "report/figures/figure_document.hpp"
#include "report/figures/headlines.hpp"
#include "report/figures/test_figures.hpp"
#include "report/page_document.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "workflow/film/film_numbers.hpp"

namespace arenite::python {
namespace {

namespace figures = report::figures;

Numbers heads_of(const std::vector<figures::Head>& heads) {
  return mapped(heads, [](const figures::Head& head) { return figures::numbers_of(head); });
}

/// The texture of a state, as its stage's recipe says.
Numbers texture_of(const StageResult& stage, const Packing& packing, bool all) {
  texture::Options options = fields::texture_options(stage);
  if (!all) options.rev_sizes = 0;
  return texture::numbers(texture::measure(packing, options), all);
}

/// A stage of a run and the packing before it; null where there is none.
struct StageOfRun {
  const StageResult& stage;
  const Packing* before = nullptr;
  const Asked* asked = nullptr;  ///< as the first stage with a size law has it
};

Numbers of_state(const StageOfRun& of, const Snapshot& state, const std::vector<const Snapshot*>& run) {
  constexpr std::size_t few = 10;  // contacts that make no statistics
  Numbers out = Numbers::tree();
  const StageResult& stage = of.stage;
  const Packing& packing = state.packing;
  if (packing.contacts.size() > few) {
    const Numbers texture = texture_of(stage, packing, true);
    out.update(figures::numbers_of(figures::state_figures(),
                                   figures::StateData{texture, mapped(packing.materials, &Material::name)},
                                   figures::whole_list));
  }
  out.update(figures::numbers_of(
      figures::stage_figures(),
      figures::StageData{stage, mapped(stage.snapshots, [](const Snapshot& s) { return &s; }), of.before},
      figures::whole_list));
  std::vector<Numbers> textures;
  for (const Snapshot* one : run)
    textures.push_back(one->packing.contacts.size() > few ? texture_of(stage, one->packing, false) : Numbers::tree());
  out.update(
      figures::numbers_of(figures::run_figures(),
                          figures::RunData{mapped(textures, [](const Numbers& n) { return &n; }), &packing, *of.asked},
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
Numbers of_runs(const std::string& id, const std::vector<fields::Test>& tests) {
  return {{"drawings", mapped(figures::figure_over_runs(id).draw(tests), [](const figures::Drawing& drawing) {
             return figures::numbers_of(drawing, figures::whole_list);
           })}};
}

py::array_t<double> pairs(const std::vector<Vec2>& values) {
  std::vector<double> flat;
  for (const Vec2& v : values) flat.insert(flat.end(), {v.x, v.y});
  return taken_over(std::move(flat), {static_cast<py::ssize_t>(values.size()), 2});
}

template <class Kinds> py::dict named_kinds(const Kinds& kinds) {
  py::dict d;
  for (const auto& kind : kinds) d[py::str(kind.name)] = py::make_tuple(kind.label, kind.symbol, kind.unit);
  return d;
}

/// Coarse-grained fields as pictures show them, on a grid whose lines are at x and y.
py::dict layers_of(const StageResult& stage, const Snapshot& state) {
  Call call;
  const auto f = call.without_lock(
      [&] { return fields::fields_to_show(state.packing, fields::shear_rate_at(stage.history, state.time)); });
  std::vector<double> x, y;
  for (int c = 0; c < f.grid.columns; ++c) x.push_back(f.grid.point(c, 0).x);
  for (int r = 0; r < f.grid.rows; ++r) y.push_back(f.grid.point(0, r).y);
  py::dict d;
  d["x"] = taken_over(std::move(x));
  d["y"] = taken_over(std::move(y));
  for (const fields::CoarseLayer& layer : fields::coarse_layers())
    if (!layer.is_of_motion || fields::are_in_motion(f))
      d[py::str(layer.name)] = taken_over(layer.of(f), {f.grid.rows, f.grid.columns});
  return d;
}

void bind_pictures(py::module_& m) {
  m.def(
      "_grain_quantities", [] { return named_kinds(texture::grain_quantities()); },
      "{name: (label, symbol, unit)} of what grains are drawn by.");
  m.def(
      "_coarse_layers", [] { return named_kinds(fields::coarse_layers()); },
      "{name: (label, symbol, unit)} of pictures of coarse-grained fields.");
  m.def("_layers_of_state", &layers_of, py::arg("stage"), py::arg("state"),
        "Coarse-grained fields of a state by their names, rows from below, and x, y of their columns and rows.");
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
      "grain_values",
      [](const Packing& packing, const std::string& name) {
        Call call;
        return taken_over(call.without_lock([&] { return texture::values_of(packing, name); }));
      },
      py::arg("packing"), py::arg("name"),
      "A number of every grain: x, y, size (diameter, m), coordination (contacts), pressure, deviator (half the "
      "difference of the principal stresses, Pa), friction (mean |F_t|/F_n of the contacts that push), speed, vx, vy "
      "(m/s), spin (rad/s).");
  m.def(
      "mobilisation",
      [](const Packing& packing, std::optional<double> friction) {
        Call call;
        return taken_over(call.without_lock([&] { return texture::mobilisations(packing, friction); }));
      },
      py::arg("packing"), py::arg("friction") = py::none(),
      "Mean |F_t|/(mu F_n) of the contacts of every grain that push; of |F_t|/F_n where mu is not given; 0 without "
      "friction.");
  m.def(
      "displacements",
      [](const std::vector<const Packing*>& packings, const std::vector<double>& shear_strain) {
        if (!shear_strain.empty() && shear_strain.size() != packings.size())
          throw refusal("there are {} packings and {} shear strains; give as many", packings.size(),
                        shear_strain.size());
        std::vector<texture::Sheared> states;
        for (std::size_t k = 0; k < packings.size(); ++k)
          states.push_back({packings[k], shear_strain.empty() ? 0 : shear_strain[k]});
        Call call;
        const auto ways = call.without_lock([&] { return texture::displacements(states); });
        py::list list;
        for (const auto& way : ways) list.append(pairs(way));
        return list;
      },
      py::arg("packings"), py::arg("shear_strain") = std::vector<double>{},
      "Displacements of grains since the first of these states, m, (n, 2) for each; without the shear of a cell whose "
      "strains are given. In a periodic cell grains must not move farther than half a cell between two states.");
}

template <class Work> py::dict drawn(Work&& work) {
  Call call;
  return to_python(call.without_lock(work));
}

}  // namespace

void bind_figures(py::module_& m) {
  m.def(
      "_figure_heads",
      [] {
        return to_python({{"stage", heads_of(figures::packing_heads())},
                          {"field", heads_of(figures::field_heads())},
                          {"film", heads_of(figures::film_heads())},
                          {"runs", heads_of(figures::heads_over_runs())}});
      },
      "What is said of every figure, by the kind of part that it is of: id, name in print, title, caption, choices.");
  bind_pictures(m);
  m.attr("_notation") = figures::notation;
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
      "_test_of_stage",
      [](const StageResult& stage, const Packing* before) {
        return drawn([&] {
          const fields::Test test{stage, before};
          const auto first = figures::headlines_of(fields::kind_of(test));
          return Numbers{{"numbers", fields::test_numbers(test)},
                         {"headlines", mapped(first, [](const figures::Headline& one) {
                            return Numbers::list({one.words, one.symbol, one.name});
                          })}};
        });
      },
      py::arg("stage"), py::arg("before"),
      "What a test says by its history, and what one asks of it first: [words, symbol, dotted name].");
  m.def(
      "_figure_of_runs",
      [](const std::string& id, const std::vector<const StageResult*>& stages,
         const std::vector<const Packing*>& before) {
        std::vector<fields::Test> tests;
        for (std::size_t k = 0; k < stages.size(); ++k) tests.push_back({*stages[k], before.at(k)});
        return drawn([&] { return of_runs(id, tests); });
      },
      py::arg("id"), py::arg("stages"), py::arg("before"),
      "What a figure of several results shows, each a stage and the packing before it or None.");
  m.def(
      "_figures_of_state",
      [](const StageResult& stage, const Snapshot& state, const py::list& run, const py::list& stages) {
        std::vector<const Snapshot*> states;
        for (const py::handle& one : run) states.push_back(&one.cast<const Snapshot&>());
        const StageOfRun of = in_run(stage, stages);
        return drawn([&] { return of_state(of, state, states); });
      },
      py::arg("stage"), py::arg("state"), py::arg("run"), py::arg("stages"),
      "What the figures of a stored state, of its stage and of the run show, by the figures' ids; `run`: all states, "
      "`stages` all stages.");
  m.def(
      "_figures_of_field",
      [](const FieldResult& field) {
        return drawn([&] {
          const Numbers densities = report::densities_of(field);
          return figures::numbers_of(figures::field_figures(), figures::FieldData{field, densities},
                                     figures::whole_list);
        });
      },
      py::arg("field"), "What the figures of a field show, by their ids.");
  m.def(
      "_figures_of_film", [](const FilmResult& film) { return drawn([&] { return of_film(film); }); }, py::arg("film"),
      "What the figures of a film show, by their ids.");
}

}  // namespace arenite::python
