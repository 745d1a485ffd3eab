#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "study/recipe.hpp"

namespace arenite::app {

void add_check(CLI::App& command, int&) {
  const auto arguments = std::make_shared<RecipeArguments>();
  add_recipe_arguments(command, *arguments);
  command.callback([arguments] {
    std::fputs(study::to_toml(study::read_recipe(arguments->file, arguments->overrides)).c_str(), stdout);
  });
}

}  // namespace arenite::app
