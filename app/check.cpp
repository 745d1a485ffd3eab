#include <fmt/core.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>

#include "campaign/study.hpp"
#include "commands.hpp"
#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/text.hpp"
#include "io/disk/file.hpp"
#include "prediction_text.hpp"
#include "print.hpp"
#include "progress.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"
#include "workflow/predict.hpp"

namespace arenite::app {
namespace {

struct CheckArguments {
  std::string recipe;
  std::vector<std::string> overrides;
  bool quiet = false, json = false;
};

/// Why nothing is predicted of what a recipe makes; empty where something is.
std::string unpredicted(const recipe::Recipe& recipe) {
  return recipe.map ? "its phase map is loaded, at a cost that is not predicted" : "";
}

/// Nothing, and a sentence, where the sample of a recipe cannot be made: the recipe itself is legal.
std::optional<workflow::Prediction> predicted(const recipe::Recipe& recipe, std::string& why_not) {
  try {
    return workflow::predict(recipe);
  } catch (const InputError& error) {
    why_not = error.problems().front().message;
    return std::nullopt;
  }
}

/// The recipe goes to stdout, where it may be kept as a recipe; what is predicted of it to stderr.
void check_simulation(const recipe::Recipe& recipe, bool json) {
  const std::string text = to_toml(recipe);
  if (!json) put(stdout, text);
  std::fflush(stdout);
  if (!unpredicted(recipe).empty())
    return json ? put(stdout, to_json(Numbers::tree({{"recipe", text}}), 2) + "\n") : void();
  std::string why_not;
  const auto prediction = predicted(recipe, why_not);
  if (json) {
    Numbers numbers =
        prediction ? workflow::numbers(*prediction) : Numbers::tree({{"warnings", std::vector<std::string>{why_not}}});
    numbers["recipe"] = text;
    put(stdout, to_json(numbers, 2) + "\n");
    return;
  }
  put(stderr, prediction ? prediction_text(*prediction)
                         : fmt::format("\nwarning: `arenite run` will refuse this: {}\n", why_not));
  if (recipe.has_field()) put(stderr, "cement, grid and loads are not included in this estimate\n");
}

void check_film(const recipe::FilmRecipe& recipe, bool json) {
  const std::string text = to_toml(recipe);
  put(stdout, json ? to_json(Numbers::tree({{"recipe", text}}), 2) + "\n" : text);
}

void say(const std::vector<std::string>& notices) {
  for (const std::string& sentence : notices) print(stderr, "{}\n", sentence);
}

constexpr std::size_t most_predicted = 8;

/// Of many runs these, as far apart as they can be, the first and the last among them.
std::vector<std::size_t> looked_at(std::size_t runs) {
  const std::size_t n = std::min(runs, most_predicted);
  std::vector<std::size_t> places;
  for (std::size_t k = 0; k < n; ++k) places.push_back(n < 2 ? 0 : k * (runs - 1) / (n - 1));
  return places;
}

struct PredictedRun {
  std::string values;
  std::optional<workflow::Prediction> prediction;
  std::string why_not;
  bool is_refused = false;
};

std::string line_of(const PredictedRun& run) {
  if (!run.prediction)
    return fmt::format("{}: {}{}\n", run.values, run.is_refused ? "`arenite study run` will refuse this: " : "",
                       run.why_not);
  const workflow::Prediction& p = *run.prediction;
  std::string text = fmt::format("{}\n  {} grains, about {}, {}", run.values, p.grains, duration_text(p.seconds()),
                                 bytes_text(p.bytes()));
  if (!p.stages.empty()) {
    const fields::StagePrediction& last = p.stages.back();
    text += fmt::format("; {}: {} {}", last.name, last.states, last.states == 1 ? "state" : "states");
    if (last.strain) text += fmt::format(", strain {:.3g} %", 100 * *last.strain);
    if (last.height) text += fmt::format(", height ~{:.3g} mm", 1e3 * *last.height);
    if (last.inertial_number) text += fmt::format(", I = {:.2g}", *last.inertial_number);
  }
  text += "\n";
  for (const std::string& warning : p.warnings) text += "  warning: " + warning + "\n";
  return text;
}

Numbers numbers_of(const PredictedRun& run) {
  Numbers numbers = run.prediction ? workflow::numbers(*run.prediction)
                                   : Numbers::tree({{"warnings", std::vector<std::string>{run.why_not}}});
  numbers["values"] = run.values;
  return numbers;
}

/// All runs are read, so that each of their problems is told; some are predicted.
void check_study(const CheckArguments& a) {
  const campaign::Study study = campaign::read_study(a.recipe, a.overrides);
  say(study.notices);
  if (a.quiet) return;
  std::vector<PredictedRun> runs;
  double seconds = 0, bytes = 0;
  std::size_t known = 0;
  for (const std::size_t place : looked_at(study.runs.size())) {
    const campaign::StudyRun& run = study.runs[place];
    if (study.of_films) {
      runs.push_back({campaign::describe(run), std::nullopt, "its film is measured, at a cost that is not predicted"});
      continue;
    }
    const recipe::Recipe recipe = campaign::recipe_of(study, run);
    PredictedRun& one = runs.emplace_back(PredictedRun{campaign::describe(run), std::nullopt, unpredicted(recipe)});
    if (one.why_not.empty()) one.prediction = predicted(recipe, one.why_not), one.is_refused = !one.prediction;
    if (one.prediction) seconds += one.prediction->seconds(), bytes += one.prediction->bytes(), ++known;
  }
  const auto all = static_cast<double>(study.runs.size()) / static_cast<double>(std::max<std::size_t>(1, known));
  if (a.json) {
    put(stdout, to_json(Numbers{{"runs", study.runs.size()},
                                {"keys", study.keys},
                                {"computing_s", seconds * all},
                                {"files_bytes", bytes * all},
                                {"predicted", mapped(runs, numbers_of)}},
                        2) +
                    "\n");
    return;
  }
  std::string text = fmt::format("{} runs of {}\n\n", study.runs.size(), list_of(study.keys));
  if (runs.size() < study.runs.size()) text += fmt::format("{} of them:\n", runs.size());
  for (const PredictedRun& run : runs) text += line_of(run);
  if (known > 0)
    text += fmt::format(
        "\nall runs: about {} of CPU time and {}, less where runs share stages; cement, grid and "
        "loads are not included\n",
        duration_text(seconds * all), bytes_text(bytes * all));
  put(stdout,
      text + fmt::format("`arenite study plan {0}` lists all runs, `arenite study run {0}` runs them\n", a.recipe));
}

bool is_study(const std::string& text, const std::string& file) {
  return recipe::read_document(text, file).find("sweep") != nullptr;
}

void check(const CheckArguments& a) {
  const std::string text = io::read_file(a.recipe);
  if (is_study(text, a.recipe)) return check_study(a);
  if (recipe::describes_film(text)) {
    const auto film = recipe::read_film_recipe(a.recipe, a.overrides);
    say(film.notices);
    if (!a.quiet) check_film(film, a.json);
    return;
  }
  const auto recipe = recipe::read_recipe(a.recipe, a.overrides);
  say(recipe.notices);
  if (!a.quiet) check_simulation(recipe, a.json);
}

}  // namespace

void add_check(Options& command, int&) {
  const auto arguments = std::make_shared<CheckArguments>();
  command.add("recipe", arguments->recipe, "Recipe to read (TOML), of a simulation, a study or a film")
      .required()
      .type("RECIPE.toml");
  add_overrides(command, arguments->overrides);
  command.add("--json", arguments->json, "Print the prediction as JSON, with the recipe");
  command.add("--quiet", arguments->quiet, "Print problems only").not_with("--json");
  command.work = [arguments] { check(*arguments); };
}

}  // namespace arenite::app
