#pragma once
#include "solid/elements/load.hpp"

namespace arenite::cluster {

/// Solves samples of elements on all ranks; of the first one, whose others are in `help_out` meanwhile.
elements::OtherSolver petsc_solver();

/// Takes part in what the first rank solves, until it says that it is done.
void help_out();

/// On the first rank: nothing else will be solved.
void dismiss_the_others();

}  // namespace arenite::cluster
