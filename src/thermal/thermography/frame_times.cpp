#include "thermal/thermography/frame_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/median.hpp"

namespace arenite::thermography {

std::vector<double> frame_times(const FilmInfo& film, double frame_rate) {
  const auto frames = static_cast<std::size_t>(film.frames);
  std::vector<double> time = film.time;
  if (time.empty()) {
    const double rate = frame_rate > 0 ? frame_rate : film.frame_rate;
    if (!(rate > 0) || !std::isfinite(rate)) throw InputError("the film does not say how many frames it has a second; give the frame rate (--frame-rate, frame_rate in [film] of a recipe or beside raw frames)");
    time.resize(frames);
    for (std::size_t n = 0; n < frames; ++n) time[n] = static_cast<double>(n) / rate;
  }
  if (time.size() != frames) throw InputError(fmt::format("the film has {} frames but {} time stamps; mend its stamps", frames, time.size()));
  for (std::size_t n = 1; n < frames; ++n)
    if (!(time[n] > time[n - 1]) || !std::isfinite(time[n]))
      throw InputError(fmt::format("the time stamp of frame {} is not after that of the frame before it; mend its stamps", n));
  return time;
}

double film_length(const std::vector<double>& time) {
  const auto frames = static_cast<double>(time.size());
  return time.size() < 2 ? 0 : (time.back() - time.front()) * frames / (frames - 1);
}

double nyquist_frequency(const std::vector<double>& time) {
  std::vector<double> step;
  for (std::size_t n = 1; n < time.size(); ++n) step.push_back(time[n] - time[n - 1]);
  if (step.empty()) return 0;
  return 0.5 / median(std::move(step));
}

}  // namespace arenite::thermography
