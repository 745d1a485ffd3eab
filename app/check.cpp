#include <fmt/core.h>

#include <cstdio>
#include <memory>
#include <optional>

#include "commands.hpp"
#include "core/error.hpp"
#include "io/disk/file.hpp"
#include "prediction_text.hpp"
#include "print.hpp"
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
  if (recipe.map) return json ? put(stdout, to_json(Numbers::tree({{"recipe", text}}), 2) + "\n") : void();
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

void check(const CheckArguments& a) {
  if (recipe::describes_film(io::read_file(a.recipe))) {
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
  command.add("recipe", arguments->recipe, "Recipe to read (TOML), of a simulation or of a film")
      .required()
      .type("RECIPE.toml");
  add_overrides(command, arguments->overrides);
  command.add("--json", arguments->json, "Print the prediction as JSON, with the recipe");
  command.add("--quiet", arguments->quiet, "Print problems only").not_with("--json");
  command.work = [arguments] { check(*arguments); };
}

}  // namespace arenite::app
