#pragma once
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/film.hpp"

namespace arenite::thermography {

/// What every pixel of a film shows over those frames in which it is a finite number; NaN where it never is.
struct FrameStatistics {
  int width = 0, height = 0;
  std::size_t frames = 0;
  std::vector<float> mean;
  std::vector<float> noise;  ///< standard deviation from frame to frame: a sixth of the mean square of second
                             ///< differences of frames that follow each other, which neither drift nor rims that move
                             ///< with a load touch; 0 for one frame, and half the square of the difference of two
  std::vector<float> least, most;
  std::vector<std::int64_t> blank = {};  ///< frames that hold no whole picture (blank_frames.hpp); not among `frames`
  std::vector<std::uint32_t> without = {};  ///< frames, of the others, in which the pixel is no finite number
};

/// Of at most `most_frames` frames from the first on, 0 for all; read some at a time.
FrameStatistics frame_statistics(FilmSource& film, std::size_t most_frames = 0);

/// Pixels that never change in eight frames or more, and those that reached the top of the camera's range (2^bits - 1),
/// if the film says it.
struct Doubtful {
  std::size_t constant = 0, saturated = 0;
};
Doubtful doubtful(const FrameStatistics& statistics, int bits);

/// Why a pixel is not believed: one or more of these.
enum BadPixel : std::uint8_t { bad_level = 1, bad_gain = 2, bad_noise = 4 };

/// Marks bad pixels of any film: those that are no numbers in some frames or all, dead and hot ones, which stand out of
/// all but two of their eight neighbours more than these and the whole picture scatter, blinking and frozen ones, whose
/// noise (its logarithm) stands out of that of all pixels; by eight robust standard deviations. Up to three that touch
/// are found. An edge in the picture is no fault, since a pixel at it has neighbours of its own side. Noise is judged
/// from eight frames on.
std::vector<std::uint8_t> find_bad_pixels(const FrameStatistics& film);

/// Marks those, and pixels whose answer to two references stands out.
std::vector<std::uint8_t> find_bad_pixels(const FrameStatistics& cold, const FrameStatistics& warm);

}  // namespace arenite::thermography
