#pragma once
#include "core/parameters.hpp"
#include "workflow/identify/identify_curves.hpp"
#include "workflow/identify/identify_factor.hpp"

namespace arenite::workflow {

// Every parameter of a request but the file that it compares with: its name, unit, range and meaning, for commands and
// Python.
void declare(ParameterVisitor& visitor, StiffnessRequest& request);
void declare(ParameterVisitor& visitor, AdhesionRequest& request);
void declare(ParameterVisitor& visitor, FactorRequest& request);

}  // namespace arenite::workflow
