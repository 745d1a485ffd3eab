#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "study/recipe.hpp"

namespace arenite::app {

void add_check(CLI::App& command, int&) {
  struct Arguments {
    std::string recipe;
    std::vector<std::string> overrides;
  };
  const auto arguments = std::make_shared<Arguments>();
  command.add_option("recipe", arguments->recipe, "Recipe to read (TOML)")->required()->type_name("RECIPE.toml");
  add_overrides(command, arguments->overrides);
  command.callback([arguments] {
    std::fputs(study::to_toml(study::read_recipe(arguments->recipe, arguments->overrides)).c_str(), stdout);
  });
}

}  // namespace arenite::app
