#pragma once
#include <filesystem>
#include <string>

#include "campaign/study_folder.hpp"
#include "statistics/numbers.hpp"
#include "workflow/run.hpp"

namespace arenite::campaign {

/// The study whose films a claim is judged by; those of others are there to be looked at.
inline constexpr const char* filmed_study = "thesis-film";

/// Films the states of a run that the study's camera.toml names, with the run's seed, and measures the film. What came
/// of it is a file in the run's folder and in the store, under the hash of all that it depends on; the film is not
/// kept. False if `options` asked to stop.
bool make_film(const Study& study, const StudyFolder& folder, const StudyRun& run, const workflow::RunOptions& options);

/// Whether a film of this run was made.
bool has_film(const std::filesystem::path& run);
/// What is kept of a run's film: how it agrees with what the simulation says of the same grains, of which it knew
/// nothing (inference::Agreement: `count`, `correlation`, `slope`, `rms_Pa`, `rms_sigma_norm`); `found`, its grains in
/// metres (`x`, `y`, `radius`), their `material`, `zone` and stress over the mean as the film (`sigma_norm`) and the
/// simulation (`simulation`) have it; `texture` of grains and contacts as the film gives them, as texture::numbers
/// does. Throws InputError if no film was made.
Numbers film_numbers(const std::filesystem::path& run);
/// One of these numbers; unknown if there is no film yet.
double film_number(const std::filesystem::path& run, const char* name);

}  // namespace arenite::campaign
