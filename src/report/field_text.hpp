#pragma once
#include <string>

namespace arenite::report {

/// The numbers of a result on a raster (FieldResult::numbers_json) as lines "name  value" for people.
std::string field_text(const std::string& numbers_json);

}  // namespace arenite::report
