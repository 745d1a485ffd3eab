#pragma once

namespace arenite::app {

/// Does the work of the command that the command line names, and says what stopped it; returns the exit status.
int run_program(int argc, char** argv);

}  // namespace arenite::app
