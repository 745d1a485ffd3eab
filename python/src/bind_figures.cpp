#include <pybind11/stl.h>

#include "calls.hpp"
#include "core/mapped.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/texture/texture.hpp"
#include "module.hpp"
#include "report/figures/figure_document.hpp"
#include "report/page_document.hpp"
#include "workflow/run_film.hpp"

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

Numbers of_state(const StageResult& stage, const Snapshot& state, const std::vector<const Snapshot*>& run,
                 const Asked& asked) {
  constexpr std::size_t few = 10;  // contacts that make no statistics
  Numbers out = Numbers::tree();
  const Packing& packing = state.packing;
  if (packing.contacts.size() > few) {
    const Numbers texture = texture_of(stage, packing, true);
    out.update(figures::numbers_of(figures::state_figures(),
                                   figures::StateData{texture, mapped(packing.materials, &Material::name)},
                                   figures::whole_list));
  }
  out.update(figures::numbers_of(
      figures::stage_figures(),
      figures::StageData{stage, mapped(stage.snapshots, [](const Snapshot& s) { return &s; })}, figures::whole_list));
  std::vector<Numbers> textures;
  for (const Snapshot* one : run)
    textures.push_back(one->packing.contacts.size() > few ? texture_of(stage, one->packing, false) : Numbers::tree());
  out.update(figures::numbers_of(
      figures::run_figures(), figures::RunData{mapped(textures, [](const Numbers& n) { return &n; }), &packing, asked},
      figures::whole_list));
  return out;
}

Numbers of_film(const FilmResult& film) {
  const workflow::FilmStresses stresses =
      film.packing.grains.size() > 0
          ? workflow::film_stresses(film, workflow::texture_of(film, false).per_grain.considered)
          : workflow::FilmStresses{};
  return figures::numbers_of(figures::film_figures(), figures::FilmData{film, stresses}, figures::whole_list);
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
                          {"film", heads_of(figures::film_heads())}});
      },
      "What is said of every figure, by the kind of part that it is of: id, name in print, title, caption, choices.");
  m.def(
      "_figures_of_state",
      [](const StageResult& stage, const Snapshot& state, const py::list& run, const py::list& stages) {
        std::vector<const Snapshot*> states;
        for (const py::handle& one : run) states.push_back(&one.cast<const Snapshot&>());
        const Asked* asked = &stage.asked;  // as the first stage with a size law has it
        for (const py::handle& one : stages)
          if (asked->diameter.empty()) asked = &one.cast<const StageResult&>().asked;
        return drawn([&] { return of_state(stage, state, states, *asked); });
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
