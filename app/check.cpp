#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "io/disk/file.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::app {
namespace {

/// The recipe as it was understood, of a simulation or of a film.
std::string resolved(const std::string& file, const std::vector<std::string>& overrides) {
  if (recipe::describes_film(io::read_file(file))) return recipe::to_toml(recipe::read_film_recipe(file, overrides));
  return recipe::to_toml(recipe::read_recipe(file, overrides));
}

}  // namespace

void add_check(Options& command, int&) {
  struct Arguments {
    std::string recipe;
    std::vector<std::string> overrides;
    bool quiet = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  command.add("recipe", arguments->recipe, "Recipe to read (TOML), of a simulation or of a film").required().type("RECIPE.toml");
  add_overrides(command, arguments->overrides);
  command.add("--quiet", arguments->quiet, "Print nothing but what is wrong");
  command.work = [arguments] {
    const std::string text = resolved(arguments->recipe, arguments->overrides);
    if (!arguments->quiet) std::fputs(text.c_str(), stdout);
  };
}

}  // namespace arenite::app
