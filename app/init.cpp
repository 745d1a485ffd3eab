#include <CLI/CLI.hpp>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "commands.hpp"
#include "core/error.hpp"
#include "io/atomic_file.hpp"
#include "study/recipe_templates.hpp"

namespace arenite::app {
namespace {

struct InitArguments {
  std::string name, file;
};

void write_new(const std::string& file, const std::string& text) {
  std::error_code error;
  if (std::filesystem::exists(file, error)) {
    throw InputError(file, 0, "is there already and is left as it is; give another name");
  }
  io::write_atomically(file, text);
  std::printf("%s written; now `arenite run %s`\n", file.c_str(), file.c_str());
}

void list_templates() {
  for (const auto& each : study::recipe_templates()) std::printf("%-11s %s\n", each.name, each.sentence);
  std::puts("\n`arenite init NAME recipe.toml` writes one.");
}

}  // namespace

void add_init(CLI::App& command, int&) {
  const auto arguments = std::make_shared<InitArguments>();
  std::vector<std::string> names;
  for (const auto& each : study::recipe_templates()) names.emplace_back(each.name);
  command.add_option("template", arguments->name, "Kind of sample; without it the kinds are listed")->type_name("TEMPLATE")->check(CLI::IsMember(names));
  command.add_option("file", arguments->file, "File to write, which must not exist; without it the recipe is printed")
      ->type_name("FILE");
  command.callback([arguments] {
    if (arguments->name.empty()) return list_templates();
    for (const auto& each : study::recipe_templates()) {
      if (arguments->name != each.name) continue;
      const std::string text = study::to_commented_toml(each.make());
      if (arguments->file.empty()) std::fputs(text.c_str(), stdout);
      else write_new(arguments->file, text);
    }
  });
}

}  // namespace arenite::app
