#include "io/film_times.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/median.hpp"

namespace arenite::io {

void take_stamps(FilmInfo& info, std::vector<double> stamp) {
  info.time.clear();
  if (stamp.size() < 2 || static_cast<std::int64_t>(stamp.size()) != info.frames) return;
  double days = 0;
  for (std::size_t i = 0; i < stamp.size(); ++i) {
    if (!std::isfinite(stamp[i])) return info.remarks.push_back(fmt::format("The time stamp of frame {} is not a number; stamps are left aside.", i));
    stamp[i] += days;
    if (i > 0 && stamp[i] < stamp[i - 1] - 43200) {
      days += 86400;
      stamp[i] += 86400;
    }
  }
  const double start = stamp[0];
  for (double& t : stamp) t -= start;  // before they are compared: rounding may make equal what was not
  if (std::all_of(stamp.begin(), stamp.end(), [&](double t) { return t == stamp[0]; })) return;
  for (std::size_t i = 1; i < stamp.size(); ++i)
    if (!(stamp[i] > stamp[i - 1]) || !std::isfinite(stamp[i]))
      return info.remarks.push_back(fmt::format("The time stamp of frame {} is not after that of the frame before; stamps are left aside.", i));
  info.time = std::move(stamp);
}

FrameIntervals frame_intervals(const FilmInfo& info) {
  FrameIntervals times;
  const double set = info.frame_rate > 0 ? 1 / info.frame_rate : 0;
  if (info.time.size() < 2) {
    times.interval = set;
    times.duration = set * static_cast<double>(std::max<std::int64_t>(info.frames - 1, 0));
    return times;
  }
  std::vector<double> step(info.time.size() - 1);
  for (std::size_t i = 0; i < step.size(); ++i) step[i] = info.time[i + 1] - info.time[i];
  times.interval = median(step);
  times.duration = info.time.back() - info.time.front();
  const double unit = set > 0 ? set : times.interval;
  for (std::size_t i = 0; i < step.size(); ++i) {
    times.dropped += std::max<std::int64_t>(std::llround(std::min(step[i] / unit, 1e15)) - 1, 0);
    if (step[i] > 1.5 * times.interval) times.gap.push_back(static_cast<std::int64_t>(i) + 1);
  }
  return times;
}

}  // namespace arenite::io
