#include "workflow/film/run_film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <optional>
#include <utility>

#include "core/problems.hpp"
#include "core/version.hpp"
#include "io/disk/file.hpp"
#include "io/film/film.hpp"
#include "io/results/results.hpp"
#include "model/elasticity/disk_stress.hpp"
#include "model/film_place.hpp"
#include "workflow/film/film_correction.hpp"
#include "workflow/film/film_numbers.hpp"
#include "workflow/film/measure_film.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/runner.hpp"
#include "workflow/stage_keys.hpp"
#include "workflow/store.hpp"

namespace arenite::workflow {

namespace fs = std::filesystem;

namespace {

/// The grains at the smallest load as a table that recipes read; lengths count from the container's lower left corner.
std::string table_of(const FilmResult& film) {
  const Grains grains = in_metres(film.grains, {film.origin, film.pixel});
  std::string text = "id,x [m],y [m],radius [m],material\n";
  for (std::size_t i = 0; i < grains.size(); ++i)
    text += fmt::format("{},{},{},{},{}\n", grains.id[i], grains.position[i].x, grains.position[i].y, grains.radius[i],
                        film.packing.materials[static_cast<std::size_t>(grains.material[i])].name);
  return text;
}

recipe::Recipe read_companion_recipe(const recipe::FilmRecipe& recipe) {
  const auto file = recipe.beside(recipe.simulation->recipe).string();
  recipe::Recipe companion = recipe::read_recipe(file);
  companion.source_file = file;
  for (const auto& name : {recipe.simulation->low, recipe.simulation->high}) {
    const auto named = [&](const recipe::Stage& stage) { return stage.name == name; };
    if (std::none_of(companion.stages.begin(), companion.stages.end(), named))
      refuse(file, "has no stage \"{}\", which [simulation] of {} names", name, recipe.source_file);
  }
  return companion;
}

recipe::Recipe companion_recipe(const recipe::FilmRecipe& recipe, const fs::path& grains) {
  recipe::Recipe companion = read_companion_recipe(recipe);
  companion.populations.clear();
  companion.packing.method = recipe::PackingParameters::Method::file;
  companion.packing.file = fs::absolute(grains).string();
  companion.container.width = recipe.container.width;
  companion.container.height = recipe.container.height;
  return companion;
}

/// The two stages that [simulation] names, at the smallest and at the largest load, by their places; nothing if one is
/// missing.
std::optional<std::pair<std::size_t, std::size_t>> compared_stages(const RunOutcome& outcome,
                                                                   const recipe::SimulationSection& simulation) {
  const auto place = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(outcome.stages, name, &StageResult::name) -
                                    outcome.stages.begin());
  };
  const std::pair found{place(simulation.low), place(simulation.high)};
  return std::max(found.first, found.second) < outcome.stages.size() ? std::optional(found) : std::nullopt;
}

/// Simulates the grains that were found in a film, from their places at the smallest load, by the recipe that
/// [simulation] names: its packing is replaced, its container, laws and stages are kept. False if it was stopped.
bool add_companion(const recipe::FilmRecipe& recipe, const FilmRunOptions& options, FilmResult& film,
                   RunOutcome& outcome) {
  RunOptions companion = options;
  const auto parts = options.store ? options.store->for_parts() : nullptr;
  companion.store = parts.get();
  companion.out = options.out / "simulation";
  companion.progress = [&](const Progress& p) {
    Progress shown = p;
    shown.name = "simulation: " + p.name;
    shown.stage = 10 + p.stage;
    shown.stages = 11 + p.stages;
    options.progress(shown);
  };
  make_folder(companion.out);
  const fs::path grains = companion.out / "grains.csv";
  io::write_atomically(grains, table_of(film));
  outcome = run(companion_recipe(recipe, grains), companion);
  if (outcome.interrupted) return false;
  const auto& stages = outcome.stages;
  if (const auto ends = compared_stages(outcome, *recipe.simulation)) {
    const Packing &low = stages[ends->first].snapshots.back().packing,
                  &high = stages[ends->second].snapshots.back().packing;
    film.simulation = {elasticity::stress_change(&low, high), elasticity::stress_of_disks(high)};
  }
  if (!outcome.converged)
    options.notice("the companion simulation did not reach equilibrium: " +
                   (stages.empty() ? std::string() : stages.back().outcome));
  return true;
}

/// Fills in the film's texture and numbers. That of the companion simulation at the largest load is the run's own,
/// unless its stage was there already.
void measure_grains(const recipe::FilmRecipe& recipe, FilmOutcome& outcome, FilmResult& film) {
  const auto& texture = outcome.simulation.measured.films.emplace_back(
      film.packing.grains.size() > 0 ? texture_of(film) : texture::Texture{});
  std::optional<texture::Texture> simulation;
  if (recipe.simulation)
    if (const auto ends = compared_stages(outcome.simulation, *recipe.simulation)) {
      texture::Options options;
      options.rev.sizes = 0;
      simulation = outcome.simulation.measured.stages[ends->second];
      if (!simulation)
        simulation = texture::measure(outcome.simulation.stages[ends->second].snapshots.back().packing, options);
    }
  film.numbers = film_numbers(film, *texture, simulation ? &*simulation : nullptr);
}

/// What was doubted of a stored film.
std::vector<std::string> doubts_of(const FilmResult& r) {
  return r.numbers.contains("checks") ? r.numbers["checks"].value("doubts", std::vector<std::string>{})
                                      : std::vector<std::string>{};
}

/// The film as it came to be known: maps, grains, forces. Nothing if it was stopped.
std::optional<FilmResult> measured(const fs::path& film, FilmSource& source, const recipe::FilmRecipe& recipe,
                                   const FilmRunOptions& options) {
  FilmResult result;
  result.name = "film";
  try {
    recipe::FilmRecipe led = recipe;
    if (const auto load = load_signal_of(film, source.info(), recipe.lockin.frequency, options.notice)) {
      led.lockin.frequency = load->frequency;
      if (!led.lockin.phase) led.lockin.phase = load->phase;
    }
    if (!measure_film(led, options, source, result)) return std::nullopt;
  } catch (const InputError& error) { throw in_file(error, film.string()); }
  return result;
}

}  // namespace

StageResult measured_stage(const FilmResult& film) {
  StageResult stage;
  stage.name = "measured peak to peak";
  stage.provenance = film.provenance;
  stage.outcome = film.outcome;
  Snapshot& snapshot = stage.snapshots.emplace_back();
  snapshot.label = "change between the smallest and the largest load";
  snapshot.packing = film.packing;
  return stage;
}

FilmOutcome run_film(const fs::path& film, const recipe::FilmRecipe& recipe, const FilmRunOptions& options) {
  for (const std::string& sentence : recipe.notices) options.notice(sentence);
  FilmOutcome outcome;
  const auto source = io::open_film(film, recipe.choice());
  refuse_temperatures(recipe, film, source->info());
  for (const std::string& remark : source->info().remarks) options.notice(remark);
  KnownFilms known;
  const PlannedStage stage = planned_stage(1, "film", film_key(film, *source, recipe, known), false);
  if (recipe.simulation) read_companion_recipe(recipe);
  outcome.file = options.out / stage.file;
  const ResultFolder folder(options.out, {stage.file}, "film");
  if (const std::string sentence = folder.what_was_put_aside(); !sentence.empty()) options.notice(sentence);
  const auto make = [&](const fs::path&) -> std::optional<FilmResult> {
    auto result = measured(film, *source, recipe, options);
    if (!result) return std::nullopt;
    if (recipe.simulation && !add_companion(recipe, options, *result, outcome.simulation)) return std::nullopt;
    measure_grains(recipe, outcome, *result);
    result->outcome = fmt::format("{} grains and {} contacts at {:.6g} Hz", result->packing.grains.size(),
                                  result->packing.contacts.size(), result->maps.frequency);
    result->provenance = {
        version,     "film", stage.hash, to_toml(recipe), recipe.seed, "", {{"film", film.filename().string()}},
        recipe.title};
    return result;
  };
  bool reused = false;
  auto result = carry_out<FilmResult>(
      {stage, outcome.file, make, io::write_film_result, io::read_film_result, "the film is measured again"}, options,
      reused);
  outcome.interrupted = !result;
  if (!result) return outcome;
  outcome.result = std::move(*result);
  if (!reused) return outcome;
  for (const auto& doubt : doubts_of(outcome.result)) options.notice(doubt);
  outcome.interrupted = recipe.simulation && !add_companion(recipe, options, outcome.result, outcome.simulation);
  return outcome;
}

}  // namespace arenite::workflow
