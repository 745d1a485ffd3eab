#include "campaign/virtual_film.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/texture/texture.hpp"
#include "io/results/results.hpp"
#include "model/elasticity/disk_stress.hpp"
#include "model/film_place.hpp"
#include "model/matching.hpp"
#include "thermal/inference/film_stresses.hpp"
#include "workflow/film/film_numbers.hpp"
#include "workflow/film/render_film.hpp"
#include "workflow/film/run_film.hpp"
#include "workflow/result_folder.hpp"
#include "workflow/runner.hpp"

namespace arenite::campaign {
namespace {

namespace fs = std::filesystem;

/// What is kept of a film, and the hash of what it was made from.
struct KeptFilm {
  Provenance provenance;
  Numbers numbers;
};

void write(const fs::path& file, const KeptFilm& film) {
  Numbers j = film.numbers;
  j["input_hash"] = film.provenance.input_hash;
  io::write_numbers_file(file, j);
}

KeptFilm read(const fs::path& file) {
  KeptFilm film;
  film.numbers = io::read_numbers_file(file);
  if (const Numbers* const former = film.numbers.at_path("/grains")) film.numbers["count"] = Numbers(*former);
  film.provenance.input_hash = film.numbers.value("input_hash", "");
  return film;
}

fs::path file_in(const fs::path& run) { return run / "virtual-film.hdf5"; }

/// Of a stage of the run's plan; empty if it has none of that name.
std::string hash_of(const StudyRun& run, const std::string& stage) {
  const auto at = std::ranges::find(run.stages, stage, &workflow::PlannedStage::name);
  return at == run.stages.end() ? "" : at->hash;
}

Packing state_of(const fs::path& run, const std::string& stage) {
  if (auto state = workflow::last_state(run, stage)) return std::move(*state);
  throw InputError(run.string(), 0,
                   "there is no stage \"" + stage + "\" of this run; remove its folder and run the study again");
}

/// Of every grain found at the smallest load the simulated one that lies nearest in that state.
std::vector<std::size_t> simulated_grains(const FilmResult& film, const Packing& start) {
  const Vec2 corner = start.domain.corner();
  return nearest_grains(in_metres(film.grains, {film.origin, film.pixel}).position,
                        mapped(start.grains.position, [&](Vec2 centre) { return centre - corner; }));
}

/// Those whose stress is known.
Numbers found_grains(const FilmResult& film, const std::vector<double>& truth) {
  const Grains& grains = film.packing.grains;
  const auto found = statistics::over_mean(film.peak_to_peak.sigma_hyd), simulated = statistics::over_mean(truth);
  Numbers j = Numbers::tree();
  for (const char* name : {"x", "y", "radius", "material", "zone", "sigma_norm", "simulation"})
    j[name] = Numbers::list();
  for (std::size_t i = 0; i < grains.size(); ++i) {
    if (!std::isfinite(found[i]) || !std::isfinite(simulated[i])) continue;
    j["x"].push_back(grains.position[i].x);
    j["y"].push_back(grains.position[i].y);
    j["radius"].push_back(grains.radius[i]);
    j["material"].push_back(grains.material[i]);
    j["zone"].push_back(grains.zone[i]);
    j["sigma_norm"].push_back(found[i]);
    j["simulation"].push_back(simulated[i]);
  }
  return j;
}

/// With curves, but without values by grain.
Numbers curves_of(const FilmResult& film) {
  auto measured = workflow::texture_of(film, false);
  measured.per_grain = {};
  return texture::numbers(measured, true);
}

/// Renders the film into `folder` and measures it; nothing if it was stopped.
std::optional<FilmResult> measured_film(const recipe::FilmRecipe& camera, const fs::path& run, const fs::path& folder,
                                        const std::function<bool()>& asked_to_stop) {
  const auto files =
      workflow::render_film(camera, run, {.out = folder, .progress = [&](double) { return !asked_to_stop(); }});
  if (files.empty()) return std::nullopt;
  workflow::FilmRunOptions measuring;
  measuring.out = folder / "result";
  measuring.asked_to_stop = asked_to_stop;
  auto film = run_film(files.front(), recipe::read_film_recipe(files.back().string(), {}), measuring);
  if (film.interrupted) return std::nullopt;
  return std::move(film.result);
}

/// The film of a run, how it agrees with the run's states, and nothing if it was stopped.
std::optional<Numbers> filmed(const recipe::FilmRecipe& camera, const fs::path& run,
                              const std::function<bool()>& asked_to_stop) {
  const fs::path folder = run / "film";
  auto film = measured_film(camera, run, folder, asked_to_stop);
  if (!film) return std::nullopt;
  std::optional<Packing> low;
  if (!camera.camera->low.empty()) low = state_of(run, camera.camera->low);
  const Packing high = state_of(run, camera.camera->high);
  const auto simulated = simulated_grains(*film, low ? *low : high);
  const auto change = elasticity::stress_change(low ? &*low : nullptr, high);
  const auto truth = mapped(simulated, [&](std::size_t grain) { return change[grain]; });
  film->packing.grains.zone.assign(simulated.size(), 0);  // who glues grains knows which
  for (std::size_t i = 0; i < simulated.size(); ++i) film->packing.grains.zone[i] = high.grains.zone[simulated[i]];
  const auto found =
      inference::agreement(film->peak_to_peak.sigma_hyd, truth, std::vector<std::uint8_t>(truth.size(), 1));
  fs::remove_all(folder);
  Numbers numbers = inference::numbers(found);
  numbers["found"] = found_grains(*film, truth);
  numbers["texture"] = curves_of(*film);
  return numbers;
}

}  // namespace

bool make_film(const Study& study, const StudyFolder& folder, const StudyRun& run,
               const workflow::RunOptions& options) {
  const auto camera = recipe::read_film_recipe((folder.out / "camera.toml").string(),
                                               {fmt::format("seed={}", recipe_of(study, run).seed)});
  if (!camera.camera)
    refuse(camera.source_file, "there is no section [camera]; add it with high = \"NAME\" of the stage that is filmed");
  const std::string hash =
      workflow::virtual_film_key(camera, hash_of(run, camera.camera->low), hash_of(run, camera.camera->high));
  const auto make = [&](const fs::path&) -> std::optional<KeptFilm> {
    auto numbers = filmed(camera, folder.run(run.name), options.asked_to_stop);
    if (!numbers) return std::nullopt;
    KeptFilm kept{{}, std::move(*numbers)};
    kept.provenance.input_hash = hash;
    return kept;
  };
  const workflow::Store store(folder.store, options.notice);
  workflow::RunOptions shared = options;
  shared.store = &store;
  bool reused = false;
  const workflow::StageRecord<KeptFilm> stage{{"film", hash, {}},      file_in(folder.run(run.name)), make, write, read,
                                              "the film is made again"};
  return carry_out(stage, shared, reused).has_value();
}

bool has_film(const fs::path& run) { return fs::exists(file_in(run)); }

Numbers film_numbers(const fs::path& run) {
  if (!has_film(run))
    throw InputError(run.string(), 0, "no film of this run was made; arenite verify thesis without --small makes it");
  return read(file_in(run)).numbers;
}

double film_number(const fs::path& run, const char* name) {
  const Numbers j = read(file_in(run)).numbers;
  const Numbers* value = j.at_path(fmt::format("/{}/value", name));
  if (!value) value = j.at_path(fmt::format("/{}", name));
  return value && value->is_number() ? value->get<double>() : statistics::unknown;
}

}  // namespace arenite::campaign
