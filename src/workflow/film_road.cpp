#include "workflow/film_road.hpp"

#include <fmt/format.h>

#include <optional>

#include "core/error.hpp"
#include "core/version.hpp"
#include "io/film.hpp"
#include "io/film_result_file.hpp"
#include "io/run_folder.hpp"
#include "io/sealed_file.hpp"
#include "statistics/numbers.hpp"
#include "workflow/film_checks.hpp"
#include "workflow/film_correction.hpp"
#include "workflow/film_key.hpp"
#include "workflow/film_load_signal.hpp"
#include "workflow/film_numbers.hpp"
#include "workflow/film_twin.hpp"
#include "workflow/measure_film.hpp"
#include "workflow/result_folder.hpp"

namespace arenite::study {
namespace {

namespace fs = std::filesystem;

/// False if it was stopped; otherwise `loaded` is the simulated sample at the largest load.
bool add_twin(const FilmRecipe& recipe, const FilmRunOptions& options, FilmOutcome& outcome, Packing& loaded) {
  RunOptions run;
  run.out = options.out / "twin";
  run.notice = options.notice;
  run.asked_to_stop = options.asked_to_stop;
  run.progress = [&](const Progress& p) {
    Progress shown = p;
    shown.name = "twin: " + p.name;
    shown.stage = 10 + p.stage;
    shown.stages = 11 + p.stages;
    options.progress(shown);
  };
  auto twin = run_twin(recipe, outcome.result, run);
  if (twin.interrupted) return false;
  outcome.result.twin = std::move(twin.stresses);
  outcome.twin = std::move(twin.stages);
  loaded = std::move(twin.loaded);
  if (!twin.converged) options.notice("the simulation beside the film found no equilibrium: " + twin.outcome);
  return true;
}

std::string sentence_of(const FilmResult& r) {
  return fmt::format("{} grains and {} contacts at {:.6g} Hz", r.packing.grains.size(), r.packing.contacts.size(), r.maps.frequency);
}

/// What was doubted of a stored film.
std::vector<std::string> doubts_of(const FilmResult& r) {
  return r.numbers.contains("checks") ? r.numbers["checks"].value("doubts", std::vector<std::string>{}) : std::vector<std::string>{};
}

/// What the store has of this film; nothing for a file that is missing or damaged.
std::optional<FilmResult> stored(const fs::path& file, const FilmRunOptions& options) {
  if (!fs::exists(file)) return std::nullopt;
  try {
    return io::read_film_result(file);
  } catch (const io::DamagedFile&) {
    options.notice(fmt::format("{}: is empty, cut short or changed; the film is measured again", file.string()));
    return std::nullopt;
  }
}

}  // namespace

StageResult measured_stage(const FilmResult& film) {
  StageResult stage;
  stage.name = "measured swing";
  stage.provenance = film.provenance;
  stage.outcome = film.outcome;
  Frame frame;
  frame.label = "swing between the smallest and the largest load";
  frame.packing = film.packing;
  stage.frames.push_back(std::move(frame));
  return stage;
}

FilmOutcome run_film(const fs::path& film, const FilmRecipe& recipe, const FilmRunOptions& options) {
  FilmOutcome outcome;
  const auto source = io::open_film(film, reading_of(recipe));
  refuse_temperatures(recipe, film, source->info());
  const std::string key = film_key(film, *source, recipe);
  if (recipe.twin) read_twin_recipe(recipe);
  outcome.file = options.out / io::stage_file_name(1, "film", key);
  if (const auto former = options.out / io::full_stage_file_name(1, "film", key); fs::exists(former)) fs::rename(former, outcome.file);
  FilmResult& r = outcome.result;
  Packing loaded;
  if (auto known = stored(outcome.file, options); known && known->provenance.input_hash == key) {
    r = std::move(*known);
    for (const auto& doubt : doubts_of(r)) options.notice(doubt);
    outcome.interrupted = recipe.twin && !add_twin(recipe, options, outcome, loaded);
    return outcome;
  }
  r.name = "film";
  try {
    FilmRecipe led = recipe;
    if (const auto load = load_signal_of(film, source->info(), recipe.lockin.frequency, options.notice)) {
      led.lockin.frequency = load->frequency;
      if (!led.lockin.phase) led.lockin.phase = load->phase;
    }
    outcome.interrupted = !measure_film(led, options, *source, r);
  } catch (const InputError& error) {
    throw in_file(error, film.string());
  }
  if (outcome.interrupted) return outcome;
  make_folder(options.out);
  if (recipe.twin && !add_twin(recipe, options, outcome, loaded)) {
    outcome.interrupted = true;
    return outcome;
  }
  r.numbers = film_numbers(r, loaded.grains.size() > 0 ? &loaded : nullptr);
  r.outcome = sentence_of(r);
  r.provenance = {version, "film", key, to_toml(recipe), recipe.seed, "", {{"film", film.filename().string()}}};
  io::write_film_result(outcome.file, r);
  return outcome;
}

}  // namespace arenite::study
