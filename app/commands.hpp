#pragma once
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace arenite::app {

/// Exit statuses of the program.
enum Status : int { done = 0, other_failure = 1, bad_input = 2, not_converged = 3 };

/// One command of the program. `add` gives the (already named) sub-command its arguments and a callback that does the
/// work, prints its result on stdout, and sets `status` where the end is not `done`. Callbacks let InputError through:
/// main prints it and exits with `bad_input`.
struct Command {
  const char* name;
  const char* sentence;
  void (*add)(CLI::App& command, int& status);
};

/// All commands, in the order of the help.
const std::vector<Command>& commands();

/// Changes to a recipe, key=value, as `run` and `check` take them.
void add_overrides(CLI::App& command, std::vector<std::string>& overrides);

void add_init(CLI::App& command, int& status);
void add_check(CLI::App& command, int& status);
void add_show(CLI::App& command, int& status);
void add_export(CLI::App& command, int& status);
void add_run(CLI::App& command, int& status);
void add_study(CLI::App& command, int& status);
void add_verify(CLI::App& command, int& status);
void add_load(CLI::App& command, int& status);
void add_lockin(CLI::App& command, int& status);
void add_step(CLI::App& command, int& status);
void add_grains(CLI::App& command, int& status);
void add_measure(CLI::App& command, int& status);
void add_identify(CLI::App& command, int& status);
void add_film(CLI::App& command, int& status);
void add_camera(CLI::App& command, int& status);
void add_figures(CLI::App& command, int& status);
void add_doctor(CLI::App& command, int& status);
void add_completion(CLI::App& command, int& status);
void add_man(CLI::App& command, int& status);

}  // namespace arenite::app
