#pragma once
#include <optional>
#include <string_view>

namespace arenite::io {

/// Seconds of a unit of time as other programs write it, "" being a second; nothing for an unknown one.
std::optional<double> seconds_of(std::string_view unit);

/// A length in metres of a unit as other programs write it ("um", "micron", "millimeters", every unit of recipes);
/// nothing where the unit is empty or no known length.
std::optional<double> in_metres(double length, std::string_view unit);

}  // namespace arenite::io
