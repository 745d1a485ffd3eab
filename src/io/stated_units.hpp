#pragma once
#include <optional>
#include <string_view>

#include "core/units.hpp"

namespace arenite::io {

/// Seconds of a unit of time as other programs write it, "" being a second; nothing for an unknown one.
std::optional<double> seconds_of(std::string_view unit);

/// A length in metres of a unit as other programs write it ("um", "micron", "millimeters", every unit of recipes);
/// nothing where the unit is empty or no known length.
std::optional<double> in_metres(double length, std::string_view unit);

/// Frames a second as programs state them at the start of a text, by a rate ("0.1 kHz", "30 fps") or by the time from
/// one to the next ("33 ms"). A number without unit is in `unit`, or in the SI unit of `bare`. Nothing for what is
/// neither, or not above 0.
std::optional<double> frames_per_second(std::string_view text, Dimension bare, std::string_view unit = {});

}  // namespace arenite::io
