#pragma once
#include <string>
#include <vector>

#include "statistics/numbers.hpp"

namespace arenite::report {

/// What a reader of a stage's numbers has to know first, one sentence each: loads that differ by more than 5 % from
/// those asked for, an energy balance that is open by more than 1 %, and a silo whose filling is low beside its
/// opening. As the numbers stored with the stage (`texture`) say.
std::vector<std::string> doubts_about(const Numbers& stage);

/// What each side was to press with and what it did: "top: 10.002 +- 0.006 kPa reached, 10 kPa asked for, spread 1.4
/// kPa".
std::vector<std::string> loads_in_words(const Numbers& stage);

}  // namespace arenite::report
