#pragma once
#include "arguments.hpp"
#include "calls.hpp"
#include "workflow/stage_watch.hpp"

namespace arenite::python {

/// Calls a function of Python with a stage under way, with Python's lock; what it raises ends the stage. Nothing
/// where it is None.
std::optional<workflow::StepFunction> step_function(Call& call, const OnStep& function, std::int64_t every);

}  // namespace arenite::python
