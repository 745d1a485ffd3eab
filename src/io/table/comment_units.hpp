#pragma once
#include <string>
#include <string_view>

#include "core/units.hpp"

namespace arenite::io {

/// The first unit of a dimension among words that state some, "mm, N"; empty without one.
std::string unit_among(std::string_view words, Dimension dimension);

/// The unit that the comments above a table state for all that has this dimension: "# units: mm, N", or for the name of
/// one "# length unit = mm"; empty without one. Of several the last counts.
std::string unit_of_comments(std::string_view text, std::string_view name, Dimension dimension);

}  // namespace arenite::io
