#include "thermal/thermography/step/step_doubts.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/option.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

constexpr std::size_t near = 4;  // frames, whose mean shows what pixels do at once

/// Sum of squares of the differences between the means of the frames from `end` on and of those before `first`.
double jump_at_once(const Matrix& value, std::size_t first, std::size_t end) {
  Matrix jump(value.rows(), 1);
  for (std::size_t k = 0; k < near; ++k)
    for (std::size_t i = 0; i < value.rows(); ++i) jump(i, 0) += (value(i, end + k) - value(i, first - 1 - k)) / near;
  return squares(jump);
}

/// What noise makes of it at a hundred places of a film: the median, and the median distance from there.
std::pair<double, double> usual_jump(const Matrix& value) {
  std::vector<double> jumps;
  for (std::size_t n = near; n + near <= value.columns(); n += std::max<std::size_t>(1, value.columns() / 100))
    jumps.push_back(jump_at_once(value, n, n));
  const double usual = median(jumps);
  return {usual, median(mapped(jumps, [&](double j) { return std::abs(j - usual); }))};
}

}  // namespace

std::vector<StepGap> other_steps(const Matrix& series, const std::vector<double>& time, const StepSides& sides) {
  std::vector<StepGap> others;
  const double jump = squares(jumps_at(series, sides));
  constexpr std::size_t least_frames = 40;
  constexpr double beyond_noise = 15, least_share = 0.01;  // of the step's squares: a tenth of it
  for (const StepSide& side : sides.side) {
    if (side.count < least_frames) continue;
    const Matrix value = series.part(side.first, side.count);
    const auto from = time.begin() + static_cast<std::ptrdiff_t>(side.first);
    const std::vector<double> times(from, from + static_cast<std::ptrdiff_t>(side.count));
    const std::size_t split = find_step(value, times, 1);
    const StepGap rise = find_rise(value, times, split);
    if (rise.first < near || rise.end + near > side.count) continue;
    const auto [noise, spread] = usual_jump(value);
    const double above = jump_at_once(value, rise.first, rise.end) - noise;
    if (rise.end - rise.first > side.count / 8 || above < least_share * jump || above < beyond_noise * spread) continue;
    StepOptions o;
    if (const StepSides there = step_sides(value, times, rise.middle, rise, o); is_a_step(there, side.count))
      others.push_back({rise.first + side.first, rise.end + side.first, rise.middle});
  }
  return others;
}

Matrix jumps_at(const Matrix& series, const StepSides& sides) {
  const auto& [before, after] = sides.side;
  Matrix jump = series.part(after.first, after.count) * after.height_weights();
  return jump -= series.part(before.first, before.count) * before.height_weights();
}

double share_alike(const Matrix& jump) {
  double sum = 0;
  for (std::size_t i = 0; i < jump.rows(); ++i) sum += jump(i, 0);
  const double all = squares(jump);
  return all > 0 ? sum * sum / static_cast<double>(jump.rows()) / all : 0;
}

bool is_a_step(const StepSides& sides, std::size_t frames) {
  return sides.evidence >
         chi_squared_above(sides.noise.pixels, std::sqrt(2 * std::log(100 * static_cast<double>(frames))));
}

std::vector<std::string> step_doubts(const std::vector<double>& time, const StepGap& rise, const StepSides& sides,
                                     const std::vector<double>& jumps, const StepOptions& o) {
  std::vector<std::string> doubts;
  const StepSide& after = sides.side[1];
  const double gap = time[rise.end] - time[rise.first - 1];
  if (rise.end > rise.first && gap > o.rise)
    doubts.push_back(
        fmt::format("the load is on its way from {:.4g} s to {:.4g} s; the {} frames in between are left out",
                    time[rise.first - 1], time[rise.end], rise.end - rise.first));
  if (o.time && rise.end > rise.first &&
      std::abs(*o.time - rise.middle) > std::max(o.rise, gap) / 4 + 2 * (time[rise.end] - time[rise.end - 1]))
    doubts.push_back(
        fmt::format("pixels jump at {:.4g} s and not at the given {:.4g} s; give that time, or none to have it found",
                    rise.middle, *o.time));
  constexpr double creeps = 0.05;
  if (after.onward > creeps)
    doubts.push_back(
        fmt::format("for about {:.2g} s after the step the pixels go on in its direction, by {:.2g} % of it: the load "
                    "creeps, or takes long to change; the jump is what they show at once",
                    after.relaxation, 100 * after.onward));
  for (const double other : jumps)
    doubts.push_back(
        fmt::format("pixels jump again at {:.4g} s, as where a camera closes its shutter; each is fitted with its own "
                    "jump there; if that is a step of the load, give {} so that one step is used",
                    other, option("window")));
  return doubts;
}

}  // namespace arenite::thermography
