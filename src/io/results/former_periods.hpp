#pragma once
#include <string_view>

namespace arenite::io {

/// Degrees after which an angle of this dotted name is the same again, for files in which numbers do not say so: half a
/// turn of axes, an m-th of a turn of the phase of an m-fold mode; 0 of all other numbers.
double former_period_deg(std::string_view name);

}  // namespace arenite::io
