#pragma once
#include <string>
#include <vector>

namespace arenite::app {

/// One argument of a command as it was declared, for texts that are generated from the declarations.
struct ArgumentText {
  std::vector<std::string> names;    ///< "--out"; empty for a positional
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

/// All commands with their tables of arguments.
std::vector<CommandText> command_texts();

}  // namespace arenite::app
