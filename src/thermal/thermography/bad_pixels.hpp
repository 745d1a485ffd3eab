#pragma once
#include <cstdint>
#include <vector>

#include "thermal/thermography/correction.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::thermography {

/// How far a pixel may stand out, in robust standard deviations (1.4826 times the median of absolute deviations).
struct BadPixelLimits {
  double level = 8;   ///< beyond all but two of its eight neighbours, in what these and the whole picture scatter
  double gain = 8;    ///< answer to two plates, against that of all pixels
  double noise = 8;   ///< logarithm of the noise, against that of all pixels
};

/// Why a pixel is not believed: one or more of these.
enum BadPixel : std::uint8_t { bad_level = 1, bad_gain = 2, bad_noise = 4 };

/// Marks bad pixels of any film by level and noise: dead and hot ones, blinking and frozen ones. Up to three
/// that touch are found. An edge in the picture is no fault, since a pixel at it has neighbours of its own side. Noise is judged from eight frames on.
std::vector<std::uint8_t> find_bad_pixels(const FrameStatistics& film, const BadPixelLimits& limits = {});

/// Marks those, and pixels whose answer to two plates stands out.
std::vector<std::uint8_t> find_bad_pixels(const FrameStatistics& cold, const FrameStatistics& warm, const BadPixelLimits& limits = {});

/// For every marked pixel the good ones nearest to it: of its eight neighbours, or of wider rings where these are bad too.
std::vector<Replacement> replacements(const std::vector<std::uint8_t>& bad, int width, int height);

}  // namespace arenite::thermography
