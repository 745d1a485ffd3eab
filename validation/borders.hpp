#pragma once
#include <functional>
#include <string>

#include "validation/results.hpp"

namespace arenite::validation {

/// "thesis-ch3, border 0": the name of a study's runs measured with another strip left out along the walls.
std::string with_border(const std::string& study, double border);

/// Measures the last states of the runs that are wanted of a study again and adds their numbers as a study of that
/// name. Runs whose files are not there are left out.
void add_with_border(Results& results, const std::string& study, double border,
                     const std::function<bool(const Run&)>& wanted);

}  // namespace arenite::validation
