#pragma once
#include <cstdint>
#include <string>
#include <vector>

#include "model/film.hpp"

namespace arenite::io {

/// What the stamps of a film say.
struct FrameIntervals {
  double interval = 0;            ///< the median time between two frames, s; 1/frame_rate without stamps, 0 if unknown
  double duration = 0;            ///< from the first to the last frame, s; 0 if unknown
  std::int64_t dropped = 0;       ///< frames of the camera that are missing between those of the film
  std::vector<std::int64_t> gap;  ///< frames before which some are missing, where stamps are not all equally far apart
};
FrameIntervals frame_intervals(const FilmInfo& info);

/// Makes the moments at which frames were taken, s from any time on, the film's times; stamps that do not run forwards,
/// or none but zeros, are left aside with a remark. A step back of nearly a day is midnight.
void take_stamps(FilmInfo& info, std::vector<double> stamp);

}  // namespace arenite::io
