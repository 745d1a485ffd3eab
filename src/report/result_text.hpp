#pragma once
#include <string>

#include "model/result.hpp"

namespace arenite::report {

/// How the last state of a stage stands: its balance, its grains by material, the forces on its walls.
std::string state_text(const StageResult& last);

/// The numbers that one asks for first, of grains, of what flows and of nodes, as rows of a table.
std::string headlines(const Numbers& numbers);

}  // namespace arenite::report
