#pragma once
#include <string>

namespace arenite::python {

/// The program's sentence with its options as arguments of Python: "choose one with --slice 0 to 3" names `slice`, and
/// "--set seed=x" becomes "changes seed=x".
std::string with_arguments(const std::string& sentence);

}  // namespace arenite::python
