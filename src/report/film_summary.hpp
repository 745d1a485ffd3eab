#pragma once
#include <string>

#include "model/film.hpp"
#include "thermal/thermography/frame_statistics.hpp"

namespace arenite::report {

/// A film in a few numbers: size, times and missing frames, what the camera says, levels and noise of the first frames.
class FilmSummary {
 public:
  /// Reads up to `most_frames` of its frames.
  explicit FilmSummary(FilmSource& film, std::size_t most_frames = 64);
  explicit FilmSummary(FilmSource&& film, std::size_t most_frames = 64) : FilmSummary(film, most_frames) {}

  std::string text() const;   ///< for people
  std::string json() const;   ///< for programs

 private:
  FilmInfo info_;
  thermography::FrameStatistics statistics_;
};

}  // namespace arenite::report
