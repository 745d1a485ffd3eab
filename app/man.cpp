#include <fmt/core.h>

#include <memory>

#include "commands.hpp"
#include "core/text.hpp"
#include "core/version.hpp"
#include "recipe/film_recipe.hpp"
#include "recipe/recipe.hpp"

namespace arenite::app {
namespace {

/// Text in roff: its special characters are escaped.
std::string roff(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\\') {
      result += "\\e";
    } else if (c == '-') {
      result += "\\-";
    } else if ((c == '.' || c == '\'') && (result.empty() || result.back() == '\n')) {
      result += std::string("\\&") + c;
    } else {
      result += c;
    }
  }
  return result;
}

std::string usage(const CommandText& command) {
  std::string line = "arenite " + command.name;
  for (const auto& argument : command.arguments) {
    if (argument.names.empty()) line += argument.required ? " " + argument.value : " [" + argument.value + "]";
  }
  return line + " [OPTIONS]";
}

std::string section(const CommandText& command) {
  std::string text = fmt::format(".SS {}\n{}.\n", roff(usage(command)), roff(command.sentence));
  for (const auto& argument : command.arguments) {
    std::string label = list_of(argument.names);
    if (!argument.value.empty()) label += (label.empty() ? "" : " ") + argument.value;
    text += fmt::format(".TP\n.B {}\n{}", roff(label), roff(argument.sentence));
    if (!argument.choices.empty()) text += fmt::format(" (one of: {})", roff(list_of(argument.choices)));
    text += "\n";
  }
  return text;
}

void print_page(const std::vector<CommandText>& tree) {
  fmt::print(".TH ARENITE 1 \"\" \"arenite {}\" \"User commands\"\n", roff(version));
  fmt::print(".SH NAME\narenite \\- micromechanics of composite and cemented granular materials\n");
  fmt::print(".SH SYNOPSIS\n.B arenite\n.I COMMAND\n[...]\n.SH COMMANDS\n");
  for (const auto& command : tree) fmt::print("{}", section(command));
  fmt::print(
      ".SH EXIT STATUS\n"
      ".TP\n.B 0\nDone.\n"
      ".TP\n.B 2\nBad input: each problem is one line on stderr, with its place and how to fix it.\n"
      ".TP\n.B 3\nNot converged, or a claim failed; the state reached is reported and kept.\n"
      ".TP\n.B 1\nAnything else.\n");
}

}  // namespace

void add_man(Options& command, int&) {
  const auto keys = std::make_shared<bool>(false), film_keys = std::make_shared<bool>(false);
  command.add("--keys", *keys, "Print the reference of all keys of a recipe instead (Markdown)");
  command.add("--film-keys", *film_keys, "Print the reference of all keys of a film's recipe instead (Markdown)");
  command.footer = "To read the page: arenite man | man -l -";
  command.work = [keys, film_keys] {
    if (*keys) fmt::print("{}", recipe::key_reference());
    else if (*film_keys) fmt::print("{}", recipe::film_key_reference());
    else print_page(command_texts());
  };
}

}  // namespace arenite::app
