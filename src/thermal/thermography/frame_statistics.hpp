#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/film.hpp"

namespace arenite::thermography {

/// What every pixel of a film shows over its frames.
struct FrameStatistics {
  int width = 0, height = 0;
  std::size_t frames = 0;
  std::vector<float> mean;
  std::vector<float> noise;  ///< standard deviation from frame to frame: half the mean square of differences of
                             ///< frames that follow each other, which slow changes hardly touch; 0 for one frame
  std::vector<float> least, most;
};

/// Of at most `most_frames` frames from the first on, 0 for all; read some at a time.
FrameStatistics frame_statistics(FilmSource& film, std::size_t most_frames = 0);

/// Pixels that never change in eight frames or more, and those that reached the top of the camera's range (2^bits - 1), if the film says it.
struct Doubtful {
  std::size_t constant = 0, saturated = 0;
};
Doubtful doubtful(const FrameStatistics& statistics, int bits);

/// How far a pixel may stand out, in robust standard deviations (1.4826 times the median of absolute deviations).
struct BadPixelLimits {
  double level = 8;  ///< beyond all but two of its eight neighbours, in what these and the whole picture scatter
  double gain = 8;   ///< answer to two references, against that of all pixels
  double noise = 8;  ///< logarithm of the noise, against that of all pixels
};

/// Why a pixel is not believed: one or more of these.
enum BadPixel : std::uint8_t { bad_level = 1, bad_gain = 2, bad_noise = 4 };

/// Marks bad pixels of any film by level and noise: dead and hot ones, blinking and frozen ones. Up to three
/// that touch are found. An edge in the picture is no fault, since a pixel at it has neighbours of its own side. Noise is judged from eight frames on.
std::vector<std::uint8_t> find_bad_pixels(const FrameStatistics& film, const BadPixelLimits& limits = {});

/// Marks those, and pixels whose answer to two references stands out.
std::vector<std::uint8_t> find_bad_pixels(const FrameStatistics& cold, const FrameStatistics& warm, const BadPixelLimits& limits = {});

}  // namespace arenite::thermography
