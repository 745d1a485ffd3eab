#pragma once
#include <string>

#include "statistics/numbers.hpp"

namespace arenite::report {

/// The numbers of a result on a raster (FieldResult::numbers) as lines "name  value" for people.
std::string field_text(const Numbers& numbers);

}  // namespace arenite::report
