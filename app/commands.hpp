#pragma once
#include <string>
#include <vector>

#include "options.hpp"

namespace arenite::elements {
struct OtherSolver;
}

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

/// Exit statuses of the program.
enum Status : int { done = 0, other_failure = 1, bad_input = 2, not_converged = 3 };

/// One command of the program. `add` fills the table of its arguments and gives it the work, which prints its result on
/// stdout, and sets `status` where the end is not `done`. InputError is let through: main prints it and exits with
/// `bad_input`.
struct Command {
  const char* name;
  const char* sentence;
  void (*add)(Options& command, int& status);
  bool works_for_long = false;  ///< on large fields; the others are done before a new start would pay (main.cpp)
};

/// All commands, in the order of the help (main.cpp).
const std::vector<Command>& commands();

/// Changes to a recipe, key=value, as `run` and `check` take them.
void add_overrides(Options& command, std::vector<std::string>& overrides);

void add_init(Options& command, int& status);
void add_check(Options& command, int& status);
void add_show(Options& command, int& status);
void add_export(Options& command, int& status);
void add_run(Options& command, int& status);
void add_watch(Options& command, int& status);
void add_study(Options& command, int& status);
void add_verify(Options& command, int& status);
void add_load(Options& command, int& status);
void add_lockin(Options& command, int& status);
void add_step(Options& command, int& status);
void add_grains(Options& command, int& status);
void add_measure(Options& command, int& status);
void add_identify(Options& command, int& status);
void add_film(Options& command, int& status);
void add_camera(Options& command, int& status);
void add_figures(Options& command, int& status);
void add_animate(Options& command, int& status);
void add_compare(Options& command, int& status);
void add_doctor(Options& command, int& status);
void add_completion(Options& command, int& status);
void add_man(Options& command, int& status);

/// `load` for samples in space that another solver takes to equilibrium; it must outlive the work.
void add_load_by(const elements::OtherSolver* solver, Options& command, int& status);

/// Throws InputError with what stands at `path`, and the command for it, where that is plainly no result: a recipe, the
/// folder of a study or of maps, a study that comes with the program, a folder without results. Films pass.
void refuse_no_result(const std::string& path);
/// As that, but a study's folder passes.
void refuse_neither_result_nor_study(const std::string& path);

}  // namespace arenite::app
