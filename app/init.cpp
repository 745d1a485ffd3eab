#include <cstdio>
#include <filesystem>
#include <functional>
#include <memory>

#include "commands.hpp"
#include "io/disk/file.hpp"
#include "print.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::app {
namespace {

struct InitArguments {
  std::string name, file;
};

void write_new(const std::string& file, const std::string& text, const std::string& command) {
  std::error_code error;
  if (std::filesystem::exists(file, error)) {
    throw InputError(file, 0, "already exists and is left unchanged; give another name");
  }
  io::write_atomically(file, text);
  print("{0} written; now `arenite {1} {0}`\n", file, command);
}

struct Template {
  std::string name, sentence, command;  ///< the command that takes the recipe
  std::function<std::string()> text;
};

std::vector<Template> all_templates() {
  std::vector<Template> list;
  for (const auto& each : recipe::recipe_templates())
    list.push_back({each.name, each.sentence, "run", [&each] {
                      return each.explained ? recipe::to_commented_toml(each.make()) : std::string(each.text);
                    }});
  list.push_back({"film", "grain stresses and contact forces from an infrared film of a loaded packing",
                  "film FILM --recipe", [] { return recipe::to_commented_toml(recipe::film_template()); }});
  list.push_back(
      {"study", "many runs of one recipe, varied by its section [sweep]", "study run", recipe::study_template});
  return list;
}

void list_templates() {
  for (const auto& each : all_templates()) print("{:<11} {}\n", each.name, each.sentence);
  print("\n`arenite init NAME recipe.toml` writes one.\n");
}

}  // namespace

void add_init(Options& command, int&) {
  const auto arguments = std::make_shared<InitArguments>();
  std::vector<std::string> names;
  for (const auto& each : all_templates()) names.push_back(each.name);
  command.add("template", arguments->name, "Kind of recipe; if not given, the kinds are listed")
      .type("TEMPLATE")
      .among(names);
  command.add("file", arguments->file, "File to write, which must not exist; if not given, the recipe is printed")
      .type("FILE");
  command.work = [arguments] {
    if (arguments->name.empty()) return list_templates();
    for (const auto& each : all_templates()) {
      if (arguments->name != each.name) continue;
      if (arguments->file.empty()) put(stdout, each.text());
      else write_new(arguments->file, each.text(), each.command);
    }
  };
}

}  // namespace arenite::app
