#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

namespace arenite::campaign {

/// The study whose films a claim is judged by; those of others are there to be looked at.
inline constexpr const char* filmed_study = "thesis-film";

/// Films the states of a run that the recipe `camera` names, with that seed, and measures the film. What came of it
/// is kept in the run's folder; the film is not. False if `asked_to_stop` said so.
bool make_film(const std::filesystem::path& run, const std::filesystem::path& camera, const std::string& seed, const std::function<bool()>& asked_to_stop);

/// Whether a film of this run was made.
bool has_film(const std::filesystem::path& run);
/// What is kept of a run's film: how it agrees with what the simulation says of the same grains, of which it knew nothing (`grains`, `correlation`,
/// `rms_sigma_norm`, `slope`; workflow::Agreement); `found`, its grains in metres (`x`, `y`, `radius`), their
/// `material`, `zone` and stress over the mean as the film (`sigma_norm`) and the simulation (`simulation`) have it; `texture` of grains and
/// contacts as the film gives them, as texture::numbers does. Throws InputError if no film was made.
Numbers film_numbers(const std::filesystem::path& run);
/// One of these numbers; unknown if there is no film yet.
double film_number(const std::filesystem::path& run, const char* name);

}  // namespace arenite::campaign
