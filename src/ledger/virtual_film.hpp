#pragma once
#include <functional>

#include "ledger/results.hpp"

namespace arenite::ledger {

/// A film of two simulated states, measured without knowing them, beside what the simulation says of the same grains.
struct FilmAgreement {
  double grains = statistics::unknown;
  double correlation = statistics::unknown, rms_sigma_norm = statistics::unknown, slope = statistics::unknown;
};

/// Films the states "low" and "high" of a run by camera.toml beside its study's recipe, and measures the film. What came of it
/// is kept in the run's folder; the film is not. False if `asked_to_stop` said so.
bool make_film(const Run& run, const std::function<bool()>& asked_to_stop);
/// What is kept of it; unknown if there is none yet.
FilmAgreement film_agreement(const Run& run);

}  // namespace arenite::ledger
