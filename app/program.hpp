#pragma once

namespace arenite::app {

/// OpenBLAS starts its threads as it is loaded and takes their number from the environment only: where that says none,
/// the program begins anew with one.
void start_anew_with_one_blas_thread(char** argv);

/// Does the work of the command that the command line names, and says what stopped it; returns the exit status.
int run_program(int argc, char** argv);

}  // namespace arenite::app
