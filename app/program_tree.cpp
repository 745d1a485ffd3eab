#include "program_tree.hpp"

#include <CLI/CLI.hpp>
#include <sstream>

namespace arenite::app {
namespace {

/// CLI11 describes IsMember as "TEXT:{vtk,csv}" in the type's name.
std::vector<std::string> choices_in(const std::string& type) {
  std::vector<std::string> choices;
  const auto open = type.find('{'), close = type.find('}');
  if (open == std::string::npos || close == std::string::npos) return choices;
  std::istringstream words(type.substr(open + 1, close - open - 1));
  for (std::string word; std::getline(words, word, ',');) choices.push_back(word);
  return choices;
}

ArgumentText argument_text(const CLI::Option& option) {
  ArgumentText text;
  for (const auto& name : option.get_lnames()) text.names.push_back("--" + name);
  for (const auto& name : option.get_snames()) text.names.push_back("-" + name);
  const std::string type = option.get_type_name();
  text.choices = choices_in(type);
  if (option.get_items_expected_max() > 0) {
    text.value = type.substr(0, type.find(':'));
    if (text.names.empty() && (text.value.empty() || text.value == "TEXT")) text.value = option.get_single_name();
  }
  text.sentence = option.get_description();
  text.required = option.get_required();
  text.repeats = option.get_items_expected_max() > 1;
  return text;
}

}  // namespace

std::vector<CommandText> program_tree(const CLI::App& program) {
  const CLI::App* root = &program;
  while (root->get_parent()) root = root->get_parent();
  std::vector<CommandText> tree;
  for (const CLI::App* command : root->get_subcommands([](const CLI::App*) { return true; })) {
    CommandText text{command->get_name(), command->get_description(), {}};
    for (const CLI::Option* option : command->get_options()) text.arguments.push_back(argument_text(*option));
    tree.push_back(std::move(text));
  }
  return tree;
}

}  // namespace arenite::app
