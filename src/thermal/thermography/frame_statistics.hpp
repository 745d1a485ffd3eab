#pragma once
#include <cstddef>
#include <vector>

#include "model/film.hpp"

namespace arenite::thermography {

/// What every pixel of a film shows over its frames.
struct FrameStatistics {
  int width = 0, height = 0;
  std::size_t frames = 0;
  std::vector<float> mean;
  std::vector<float> noise;         ///< standard deviation from frame to frame: half the mean square of differences of
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

}  // namespace arenite::thermography
