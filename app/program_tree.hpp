#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace arenite::app {

/// One argument of a command as it was declared, for texts that are generated from the declarations.
struct ArgumentText {
  std::vector<std::string> names;    ///< "--out", "-o"; empty for a positional
  std::string value;                 ///< "DIR"; empty for a flag
  std::vector<std::string> choices;  ///< where only some words are allowed
  std::string sentence;
  bool required = false;
  bool repeats = false;
};

struct CommandText {
  std::string name, sentence;
  std::vector<ArgumentText> arguments;
};

/// What main declared, command by command. `program` is the root or any of its sub-commands.
std::vector<CommandText> program_tree(const CLI::App& program);

}  // namespace arenite::app
