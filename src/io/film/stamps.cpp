#include "io/film/stamps.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "io/film/film.hpp"

namespace arenite::io {

void take_stamps(FilmInfo& info, std::vector<double> stamp) {
  info.time.clear();
  if (!stamp.empty() && std::isfinite(stamp[0])) info.start = stamp[0];
  if (stamp.size() < 2 || static_cast<std::int64_t>(stamp.size()) != info.frames) return;
  double days = 0;
  for (std::size_t i = 0; i < stamp.size(); ++i) {
    if (!std::isfinite(stamp[i]))
      return info.remarks.push_back(
          fmt::format("The time stamp of frame {} is not a number; time stamps are ignored.", i));
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
      return info.remarks.push_back(
          fmt::format("The time stamp of frame {} is not after that of the frame before; time stamps are ignored.", i));
  info.time = std::move(stamp);
  const double interval = frame_intervals(info).interval;
  if (info.frame_rate > 0 && std::abs(interval * info.frame_rate - 1) > 0.1)
    info.remarks.push_back(fmt::format(
        "Frames are stamped {:.4g} s apart, while the film states a frame rate of {:.6g} Hz; the stamps are used.",
        interval, info.frame_rate));
}

void take_numbers(FilmInfo& info, std::vector<std::int64_t> number) {
  info.number.clear();
  if (number.size() < 2 || static_cast<std::int64_t>(number.size()) != info.frames) return;
  const std::int64_t first = number.front();
  for (std::size_t i = 1; i < number.size(); ++i)
    if (number[i] <= number[i - 1])
      return info.remarks.push_back(
          fmt::format("The number of frame {} is not above that of the frame before; numbers are ignored.", i));
  for (auto& n : number) n -= first;
  if (number.back() + 1 == info.frames) return;
  info.number = std::move(number);
  const FrameIntervals found = frame_intervals(info);
  info.remarks.push_back(fmt::format(
      "By their numbers {} frames are missing, the first before frame {} of the film; times follow the numbers.",
      found.dropped, found.gap.front()));
}

void take_stamps_and_numbers(FilmInfo& info, std::vector<double> stamp, std::vector<std::int64_t> number,
                             bool rate_given) {
  const bool counted = number.size() > 1;
  if (!stamp.empty()) take_stamps(info, std::move(stamp));
  if (counted && rate_given) info.time.clear();
  if (info.time.empty()) return take_numbers(info, std::move(number));
  if (!counted) return;
  FilmInfo by_number;
  by_number.frames = info.frames;
  take_numbers(by_number, std::move(number));
  const auto missing = frame_intervals(by_number).dropped, by_time = frame_intervals(info).dropped;
  if (missing != by_time)
    info.remarks.push_back(fmt::format("By their numbers {} frames are missing, by their times {}; the times are used.",
                                       missing, by_time));
}

}  // namespace arenite::io
