#pragma once
#include "statistics/numbers.hpp"

namespace arenite::app {

/// Goes on as `python3 -m MODULE OPTIONS`, the options as one JSON object, with the Python module that was built or
/// installed with this program, and does not return. Throws InputError where there is none; `what` is what needs it,
/// "figures".
[[noreturn]] void continue_in_python(const char* what, const char* module, const Numbers& options);

}  // namespace arenite::app
