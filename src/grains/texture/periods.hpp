#pragma once
#include <string_view>

namespace arenite::texture {

/// Degrees after which an angle that a statistic tells under this dotted name is the same again: half a turn of axes,
/// an m-th of a turn of the phase of an m-fold mode; 0 of all other numbers.
double period_deg(std::string_view name);

}  // namespace arenite::texture
