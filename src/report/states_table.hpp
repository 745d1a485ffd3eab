#pragma once
#include <filesystem>
#include <string>

namespace arenite::report {

/// The stored states through the stages of a run's folder as CSV, one row each: strains since the state before the
/// stage, what curves over states have (fields::numbers_of_states), with errors as NAME_error, and the mobilised
/// friction; units in the heads of the columns. Throws InputError for what holds no such stages.
std::string states_table(const std::filesystem::path& result);

}  // namespace arenite::report
