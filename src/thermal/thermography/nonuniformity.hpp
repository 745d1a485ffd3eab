#pragma once
#include <vector>

#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::thermography {

/// One-point correction: every pixel's offset, from the mean frame of a film of an even plate. Every pixel then shows the
/// plate at the median level of all.
void correct_offsets(const FrameStatistics& plate, Correction& correction);

/// Two-point correction: gain and offset of every pixel, from two even plates of different temperature, so that every
/// pixel shows each of them at its median level. A pixel that hardly answers keeps gain 1 (find_bad_pixels finds it).
/// Throws InputError for plates of different size, or that do not differ.
void correct_gains(const FrameStatistics& cold, const FrameStatistics& warm, Correction& correction);

/// The median level of a plate: where a correction puts it.
double plate_level(const FrameStatistics& plate);

}  // namespace arenite::thermography
