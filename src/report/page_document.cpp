#include "report/page_document.hpp"
#include "report/figure_heads.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cstdlib>
#include <deque>
#include <functional>
#include <optional>
#include <utility>

#include "core/mapped.hpp"
#include "grains/fields/coarse_layers.hpp"
#include "grains/fields/loading.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/fields/test_curves.hpp"
#include "grains/texture/grain_quantities.hpp"
#include "report/drawn.hpp"
#include "report/field_document.hpp"
#include "report/figures/figure_document.hpp"
#include "report/figures/grains/grain_values.hpp"
#include "report/figures/headlines.hpp"
#include "report/figures/run_figures.hpp"
#include "report/figures/stage_figures.hpp"
#include "report/figures/state_figures.hpp"
#include "report/figures/state_numbers.hpp"
#include "report/film_document.hpp"
#include "report/number_words.hpp"
#include "report/packing_layers.hpp"
#include "report/sphere_document.hpp"
#include "report/stage_doubts.hpp"
#include "report/voxel_document.hpp"
#include "workflow/film/film_numbers.hpp"
#include "workflow/film/run_film.hpp"

namespace arenite::report {
namespace {

constexpr std::size_t history_rows = 1000;  // about as many as a figure has pixels across

/// Every k-th row and the last one.
std::vector<double> thinned(const std::vector<double>& values) {
  const std::size_t stride = (values.size() + history_rows - 1) / history_rows;
  std::vector<double> kept;
  for (std::size_t k = 0; k < values.size(); k += stride) kept.push_back(values[k]);
  if (!values.empty() && (values.size() - 1) % stride != 0) kept.push_back(values.back());
  return kept;
}

void shorten(Numbers& value) {
  for (Numbers& part : value) shorten(part);
  if (!value.is_real()) return;
  Numbers kept = std::strtod(fmt::format("{:.6g}", value.get<double>()).c_str(), nullptr);
  kept.means_as(value);
  value = std::move(kept);
}

/// Unit and sentence of each number that a statistic declares, by its dotted name: {"solid_fraction": ["", "Area of
/// grains over ..."]}.
Numbers meanings_of(const Numbers& numbers) {
  Numbers out = Numbers::tree();
  for (const auto& [name, number, meaning] : named_numbers(numbers))
    if (meaning) out[name] = Numbers::list({meaning->unit, meaning->sentence});
  return out;
}

Numbers stage_of(const StageResult& stage, const Packing* before, const ShownGrains& grains,
                 const figures::WriteList& write) {
  const auto states = grains.states_of(stage);
  Numbers shown{
      {"name", stage.name},
      {"converged", stage.converged},
      {"outcome", stage.outcome},
      {"loads", loads_in_words(stage.texture)},
      {"doubts", doubts_about(stage.texture)},
      {"figures", shortened(figures::numbers_of(figures::stage_figures(), {stage, states, before}, write, true))},
      {"provenance", provenance_of(stage.provenance)}};
  figures::add_test(shown, {stage, states, before});
  return shown;
}

/// A stage, how the texture of its states is measured, and that of its last state where it is known already.
struct ShownStage {
  const StageResult* result;
  texture::Options options;
  const texture::Texture* last = nullptr;
};

/// A film with grains as a stage, and their texture.
struct ShownFilm {
  StageResult stage;
  std::optional<texture::Texture> now;  ///< where the run does not know it
  const texture::Texture* texture;
};

/// One a film; nothing for a film without grains.
std::deque<std::optional<ShownFilm>> films_of(const PageData& data) {
  std::deque<std::optional<ShownFilm>> shown;
  for (std::size_t f = 0; f < data.films.size(); ++f) {
    const FilmResult& film = data.films[f];
    auto& one = shown.emplace_back();
    if (film.packing.grains.size() == 0) continue;
    one = ShownFilm{workflow::measured_stage(film), {}, known_of(data.measured, &workflow::KnownStatistics::films, f)};
    if (!one->texture) one->texture = &one->now.emplace(workflow::texture_of(film));
  }
  return shown;
}

/// Films with grains, and then the stages.
std::vector<ShownStage> stages_of(const PageData& data, const std::deque<std::optional<ShownFilm>>& films) {
  std::vector<ShownStage> shown;
  for (const auto& film : films)
    if (film) shown.push_back({&film->stage, {}, film->texture});
  for (std::size_t s = 0; s < data.stages.size(); ++s)
    shown.push_back({&data.stages[s], fields::texture_options(data.stages[s]),
                     known_of(data.measured, &workflow::KnownStatistics::stages, s)});
  return shown;
}

/// The last one that has states.
const ShownStage* last_stage(const std::vector<ShownStage>& stages) {
  for (auto stage = stages.rbegin(); stage != stages.rend(); ++stage)
    if (!stage->result->snapshots.empty()) return &*stage;
  return nullptr;
}

/// Of the first stage that was asked for grains by size laws; else of the first.
const Asked& asked_of(const std::vector<ShownStage>& stages) {
  const auto has_law = [](const ShownStage& stage) { return !stage.result->asked.diameter.empty(); };
  const auto at = std::ranges::find_if(stages, has_law);
  return (at == stages.end() ? stages.front() : *at).result->asked;
}

/// Fields of every so many states, so that they are no more than the page can carry.
std::size_t states_per_fields(const std::vector<ShownStage>& stages) {
  constexpr std::size_t most = 60'000;  // cells
  std::size_t cells = 0;
  for (const ShownStage& stage : stages)
    for (const Snapshot& snapshot : stage.result->snapshots)
      cells += std::min<std::size_t>(snapshot.packing.grains.size(), 2500);
  return 1 + cells / most;
}

/// Figures of a state that has a texture, whose curves nothing else shows.
void add_figures_of_state(Numbers& shown, const Packing& packing, const figures::WriteList& write) {
  if (!shown.contains("texture")) return;
  shown["figures"] = shortened(figures::numbers_of(
      figures::state_figures(), {shown.at("texture"), mapped(packing.materials, &Material::name)}, write));
  erase(shown["texture"], Trait::curve);
}

/// Figures of the run as a whole.
Numbers figures_of_run(const Numbers& snapshots, const ShownStage& last, const Asked& asked,
                       const figures::WriteList& write) {
  const Snapshot& state = last.result->snapshots.back();
  // What a laboratory measured of a film's grains, their contacts do not tell.
  const auto grains = [&](std::string_view name) {
    const bool is_known = name == "stress" && last.last && !last.last->per_grain.sigma_norm.empty();
    return is_known ? last.last->per_grain.sigma_norm : figures::grain_values(*last.result, state, name);
  };
  figures::RunData run{{}, &state.packing, asked, grains};
  for (const Numbers& snapshot : snapshots)
    run.textures.push_back(snapshot.contains("texture") ? &snapshot["texture"] : nullptr);
  return shortened(figures::numbers_of(figures::run_figures(), run, write));
}

/// How far grains have gone and turned since the first state of a stage, which places and angles alone do not tell
/// where sides are periodic, or grains come and go. Of a state in which none has, it is left out.
void add_motion_since_start(Numbers& snapshots, const ShownGrains& grains, const StageResult& stage,
                            NumberBlock& block) {
  const auto states = grains.states_of(stage);
  if (states.size() < 2) return;
  const auto* time = stage.history.find("time");
  const auto* strain = stage.history.find("shear_strain");
  const auto ways = texture::displacements(mapped(states, [&](const Snapshot* state) {
    return texture::Sheared{&state->packing, time && strain ? fields::at_time(*time, *strain, state->time) : 0.0};
  }));
  const auto turns = texture::rotations(mapped(states, [](const Snapshot* state) { return &state->packing; }));
  for (std::size_t k = 0; k < states.size(); ++k) {
    Numbers& shown = snapshots[snapshots.size() - states.size() + k];
    const auto add = [&](const char* name, const std::vector<double>& values) {
      if (std::ranges::any_of(values, [](double v) { return v != 0; }))
        shown[name] = block.add_coarse(values, std::string(texture::grain_quantity(name).unit));
    };
    add("displacement", mapped(ways[k], [](Vec2 way) { return norm(way); }));
    add("rotation", turns[k]);
  }
}

/// The states of one stage whose grains the page knows, with the textures of all in a small sample, and fields of some.
void add_states(Numbers& snapshots, Numbers& meanings, const ShownStage& stage, std::size_t s,
                const ShownGrains& grains, std::size_t every, NumberBlock& block, const figures::WriteList& write) {
  constexpr std::size_t small = 10'000;
  const auto& states = stage.result->snapshots;
  for (std::size_t f = 0; f < states.size(); ++f) {
    const Packing& packing = states[f].packing;
    if (!grains.has(packing.grains)) continue;
    const bool is_last = f + 1 == states.size();
    std::optional<texture::Texture> now;
    const texture::Texture* texture = is_last ? stage.last : nullptr;
    const bool measured = texture || is_last || packing.grains.size() <= small;
    if (!texture)
      texture = &now.emplace((measured ? texture::measure<2> : texture::grain_rows<2>)(packing, stage.options));
    const Numbers numbers = measured ? figures::state_numbers(*stage.result, states[f], *texture) : Numbers();
    snapshots.push_back(snapshot_of(states[f], s, *texture, numbers, block));
    if (const auto places = grains.places_of(packing.grains); !places.empty())
      snapshots.back()["present"] = block.add_indices(places);
    add_figures_of_state(snapshots.back(), packing, write);
    if (is_last) meanings.update(meanings_of(snapshots.back()["texture"]));
    if (!is_last && f % every != 0) continue;
    const double rate = fields::shear_rate_at(stage.result->history, states[f].time);
    if (Numbers fields = coarse_fields_of(packing, rate, block); fields.is_known())
      snapshots.back()["fields"] = std::move(fields);
  }
  add_motion_since_start(snapshots, grains, *stage.result, block);
}

}  // namespace

Numbers history_of(const History& history, NumberBlock& block) {
  Numbers columns = Numbers::tree();
  for (const History::Column& column : history.columns)
    columns[column.name] = block.add_reals(thinned(column.values), column.unit);
  return columns;
}

Numbers provenance_of(const Provenance& p) {
  Numbers options = Numbers::tree();
  for (const auto& [name, value] : p.options) options[name] = value;
  return {{"version", p.version}, {"stage", p.stage},   {"input_hash", p.input_hash}, {"seed", p.seed},
          {"kernel", p.kernel},   {"options", options}, {"recipe", p.recipe}};
}

void add_numbers(Numbers& out, const Numbers& numbers) {
  // Curves are drawn as figures, and the others stand in cards of their own.
  static const std::vector<std::string> told_elsewhere{"curves",     "pdf",        "histogram", "own_histogram",
                                                       "cumulative", "provenance", "recipe",    "stages",
                                                       "notes",      "window",     "snapshot",  "contact_orientations"};
  out["numbers"] = shortened(numbers);
  out["meanings"] = meanings_of(numbers);
  out["elsewhere"] = told_elsewhere;
}

Numbers shortened(Numbers numbers) {
  if (!numbers.is_known()) return Numbers::tree();
  shorten(numbers);
  return numbers;
}

PageDocument page_document(const PageData& data) {
  NumberBlock block;
  figures::PageLists lists(block);
  const figures::WriteList write = std::ref(lists);
  Numbers document{
      {"title", data.title}, {"notation", figures::notation}, {"words", number_words()}, {"drawn", drawn()}};
  document["figures"] = figures::heads_of_parts();
  Numbers stages = Numbers::list(), snapshots = Numbers::list();
  const auto films = films_of(data);  // stay in place while the stages point at them
  const auto shown = stages_of(data, films);
  const ShownStage* last = last_stage(shown);
  const ShownGrains grains(mapped(shown, &ShownStage::result));
  if (last) {
    document["quantities"] = named_kinds(texture::grain_quantities());
    document["layers"] = named_kinds(fields::coarse_layers<2>());
    document["materials"] = materials_of(last->result->snapshots.back().packing.materials);
    document["grains"] = grains_of(grains.all(), block);
  }
  const std::size_t every = states_per_fields(shown);
  const Packing* before = nullptr;  // of loadings; films are none
  for (std::size_t s = 0; s < shown.size(); ++s) {
    stages.push_back(stage_of(*shown[s].result, before, grains, write));
    if (const auto& states = shown[s].result->snapshots; s >= data.films.size() && !states.empty())
      before = &states.back().packing;
    if (last) add_states(snapshots, document["meanings"], shown[s], s, grains, every, block, write);
  }
  if (last) document["run"] = figures_of_run(snapshots, *last, asked_of(shown), write);
  document["stages"] = std::move(stages);
  document["snapshots"] = std::move(snapshots);
  if (!data.fields.empty()) add_fields(document, data, block, write);
  if (!data.voxels.empty()) add_volumes(document, data, block, write);
  if (!data.spheres.empty()) add_spheres(document, data, block, write);
  for (std::size_t f = 0; f < films.size(); ++f)
    add_film(document, data.films[f], films[f] ? films[f]->texture : nullptr, block, write);
  return {to_json(document), block.text()};
}

}  // namespace arenite::report
