#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "commands.hpp"
#include "study/recipe.hpp"

namespace arenite::app {

void add_check(CLI::App& command, int&) {
  const auto arguments = std::make_shared<RecipeArguments>();
  const auto keys = std::make_shared<bool>(false);
  add_recipe_arguments(command, *arguments);
  command.get_option("recipe")->required(false);
  command.add_flag("--keys", *keys, "Print the documentation of every key instead");
  command.callback([arguments, keys] {
    if (*keys) {
      std::fputs(study::key_reference().c_str(), stdout);
      return;
    }
    if (arguments->file.empty()) throw CLI::RequiredError("RECIPE.toml");
    std::fputs(study::to_toml(study::read_recipe(arguments->file, arguments->overrides)).c_str(), stdout);
  });
}

}  // namespace arenite::app
