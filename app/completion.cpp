#include <fmt/core.h>

#include <memory>

#include "commands.hpp"
#include "core/text.hpp"
#include "print.hpp"

namespace arenite::app {
namespace {

std::vector<std::string> option_names(const CommandText& command) {
  std::vector<std::string> names;
  for (const auto& argument : command.arguments)
    names.insert(names.end(), argument.names.begin(), argument.names.end());
  return names;
}

std::vector<std::string> positional_choices(const CommandText& command) {
  std::vector<std::string> words;
  for (const auto& argument : command.arguments) {
    if (argument.names.empty()) words.insert(words.end(), argument.choices.begin(), argument.choices.end());
  }
  return words;
}

std::string bash(const std::vector<CommandText>& tree) {
  std::vector<std::string> names;
  for (const auto& command : tree) names.push_back(command.name);
  std::string script = fmt::format(
      "_arenite() {{\n"
      "  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD-1]}} words=\n"
      "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n"
      "    COMPREPLY=($(compgen -W \"{}\" -- \"$word\"))\n"
      "    return\n"
      "  fi\n"
      "  case \"${{COMP_WORDS[1]}} $before\" in\n",
      list_of(names, " "));
  for (const auto& command : tree) {
    for (const auto& argument : command.arguments) {
      for (const auto& name : argument.names) {
        if (!argument.choices.empty()) {
          script += fmt::format("    '{} {}') words='{}' ;;\n", command.name, name, list_of(argument.choices, " "));
        }
      }
    }
  }
  for (const auto& command : tree) {
    std::vector<std::string> words = positional_choices(command);
    script += fmt::format("    '{} '*) words='{}'; [[ $word == -* ]] && words='{}' ;;\n", command.name,
                          list_of(words, " "), list_of(option_names(command), " "));
  }
  return script +
         "  esac\n"
         "  COMPREPLY=($(compgen -W \"$words\" -- \"$word\"))\n"
         "}\n"
         "complete -o default -F _arenite arenite\n";
}

/// Single-quoted for zsh and fish.
std::string quoted(std::string text) {
  for (std::size_t at = 0; (at = text.find('\'', at)) != std::string::npos; at += 4) text.replace(at, 1, "'\\''");
  return "'" + text + "'";
}

std::string zsh_safe(std::string text) {
  for (char& c : text) {
    if (c == ':' || c == '[' || c == ']') c = ' ';
  }
  return text;
}

std::string zsh(const std::vector<CommandText>& tree) {
  std::string script = "#compdef arenite\n_arenite() {\n  local -a commands\n  commands=(\n";
  for (const auto& command : tree) {
    script += "    " + quoted(command.name + ":" + zsh_safe(command.sentence)) + "\n";
  }
  script +=
      "  )\n  if (( CURRENT == 2 )); then\n    _describe command commands\n    return\n  fi\n  case $words[2] in\n";
  for (const auto& command : tree) {
    script += fmt::format("    {}) _arguments", command.name);
    for (const auto& argument : command.arguments) {
      const std::string action = argument.choices.empty() ? "_files" : "(" + list_of(argument.choices, " ") + ")";
      const std::string value = argument.value.empty() ? "" : fmt::format(":{}:{}", zsh_safe(argument.value), action);
      for (const auto& name : argument.names) {
        script += " \\\n      " + quoted(fmt::format("{}{}[{}]{}", argument.repeats ? "*" : "", name,
                                                     zsh_safe(argument.sentence), value));
      }
      if (argument.names.empty()) script += " \\\n      " + quoted("*" + value);
    }
    script += " ;;\n";
  }
  return script + "  esac\n}\ncompdef _arenite arenite\n";
}

std::string fish(const std::vector<CommandText>& tree) {
  std::string script;
  for (const auto& command : tree) {
    script += fmt::format("complete -c arenite -n __fish_use_subcommand -a {} -d {}\n", command.name,
                          quoted(command.sentence));
    const std::string here = fmt::format("complete -c arenite -n '__fish_seen_subcommand_from {}'", command.name);
    for (const auto& argument : command.arguments) {
      const std::string values = argument.choices.empty() ? "" : " -xa " + quoted(list_of(argument.choices, " "));
      if (argument.names.empty() && !values.empty()) script += here + values + "\n";
      for (const auto& name : argument.names) {
        const std::string option = name.starts_with("--") ? "-l " + name.substr(2) : "-s " + name.substr(1);
        script += fmt::format("{} {}{}{} -d {}\n", here, option, argument.value.empty() ? "" : " -r", values,
                              quoted(argument.sentence));
      }
    }
  }
  return script;
}

}  // namespace

void add_completion(Options& command, int&) {
  const auto shell = std::make_shared<std::string>();
  command.add("shell", *shell, "Shell to complete in").required().type("SHELL").among({"bash", "zsh", "fish"});
  command.footer = "For bash: source <(arenite completion bash)";
  command.work = [shell] {
    const auto tree = command_texts();
    print("{}", *shell == "bash" ? bash(tree) : *shell == "zsh" ? zsh(tree) : fish(tree));
  };
}

}  // namespace arenite::app
