#pragma once
#include <filesystem>
#include <string>

namespace arenite::report {

/// The stress path through the stages of a run's folder as CSV: one row a stored state, units in the heads of the
/// columns. Throws InputError for what holds no such stages.
std::string states_table(const std::filesystem::path& result);

}  // namespace arenite::report
