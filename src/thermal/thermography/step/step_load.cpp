#include "thermal/thermography/step/step_load.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "thermal/thermography/blank_frames.hpp"
#include "thermal/thermography/film_checks.hpp"
#include "thermal/thermography/segment_sums.hpp"
#include "thermal/thermography/step/step_doubts.hpp"
#include "thermal/thermography/step/step_sides.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

void check(const StepOptions& o) {
  if (o.drift_order < 0 || o.drift_order > 4) throw refusal("the drift order is {}; it must be 0 to 4", o.drift_order);
  if (!(o.rise >= 0) || !(o.window >= 0)) throw InputError("the step's rise and window must not be below 0 s");
}

/// Some thousand pixels of every frame, spread over the picture: pixels x frames. Empty if `progress` stopped it.
Matrix some_pixels(FilmSource& film, const Progress& progress) {
  const auto frames = static_cast<std::size_t>(film.info().frames), pixels = film.info().pixels();
  const std::size_t most =
      std::clamp<std::size_t>((std::size_t{1} << 25) / std::max<std::size_t>(frames, 1), 64, 1024);  // 256 MB
  const std::size_t every = (pixels + most - 1) / most, count = (pixels + every - 1) / every;
  Matrix series(count, frames);
  const auto take = [&](const auto* values, std::size_t n, std::size_t some) {
    for (std::size_t f = 0; f < some; ++f)
      for (std::size_t i = 0; i < count; ++i) series(i, n + f) = static_cast<double>(values[f * pixels + i * every]);
    return !progress || progress(static_cast<double>(n + some) / static_cast<double>(frames));
  };
  if (!read_frames(film, 0, frames, take)) return {};
  return series;
}

/// Whether a frame may hold no whole picture: a pixel is no number there, or all are 0.
bool may_lack_frames(const Matrix& series) {
  for (std::size_t n = 0; n < series.columns(); ++n) {
    const double* frame = series.column(n);
    if (std::any_of(frame, frame + series.rows(), [](double v) { return !std::isfinite(v); })) return true;
    if (std::all_of(frame, frame + series.rows(), [](double v) { return v == 0; })) return true;
  }
  return false;
}

/// Pixels less their first value and over their noise from frame to frame. Those that never change, or are no numbers,
/// are left out.
Matrix changing_pixels(const Matrix& series) {
  const std::size_t count = series.rows(), frames = series.columns();
  std::vector<double> noise(count);
  for (std::size_t n = 1; n < frames; ++n)
    for (std::size_t i = 0; i < count; ++i)
      noise[i] += std::pow(series(i, n) - series(i, n - 1), 2) / (2 * static_cast<double>(frames - 1));
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < count; ++i)
    if (noise[i] > 0 && std::isfinite(noise[i])) used.push_back(i);
  Matrix changing(used.size(), frames);
  for (std::size_t n = 0; n < frames; ++n)
    for (std::size_t k = 0; k < used.size(); ++k)
      changing(k, n) = (series(used[k], n) - series(used[k], 0)) / std::sqrt(noise[used[k]]);
  return changing;
}

/// Weighed sums of all pixels' values, less the pixel's first one.
class StepSums {
 public:
  StepSums(std::size_t pixels, std::size_t size)
      : pixels_(pixels),
        base_(pixels),
        squares_(pixels),
        sum_(size, std::vector<double>(pixels)) {}

  /// False if stopped.
  bool pass(FilmSource& film, const StepSide& side, const ThreadPool& pool,
            const std::function<bool(std::size_t)>& progress) {
    return read_frames(film, side.first, side.count, [&](const auto* frames, std::size_t first, std::size_t count) {
      pool.for_ranges(pixels_, [&](std::size_t begin, std::size_t end) {
        if (first == 0)
          for (std::size_t p = begin; p < end; ++p) base_[p] = static_cast<double>(frames[p]);
        for (std::size_t f = 0; f < count; ++f) {
          const auto* value = frames + f * pixels_;
          for (std::size_t p = begin; p < end; ++p) {
            const double d = static_cast<double>(value[p]) - base_[p];
            squares_[p] += d * d;
          }
          for (std::size_t k = 0; k < sum_.size(); ++k) {
            const double w = side.weight(first + f, k);
            for (std::size_t p = begin; p < end; ++p) sum_[k][p] += w * (static_cast<double>(value[p]) - base_[p]);
          }
        }
      });
      return progress(count);
    });
  }

  double base(std::size_t p) const { return base_[p]; }
  double squares(std::size_t p) const { return squares_[p]; }
  double at(const Matrix& functional, std::size_t p) const {
    double sum = 0;
    for (std::size_t k = 0; k < sum_.size(); ++k) sum += functional(k, 0) * sum_[k][p];
    return sum;
  }
  double explained(std::size_t p) const {
    double sum = 0;
    for (const auto& each : sum_) sum += each[p] * each[p];
    return sum;
  }

 private:
  std::size_t pixels_;
  std::vector<double> base_, squares_;
  std::vector<std::vector<double>> sum_;
};

void fill(StepMaps& maps, const StepSides& sides, const StepSums (&sums)[2]) {
  const std::size_t pixels = static_cast<std::size_t>(maps.width) * static_cast<std::size_t>(maps.height);
  for (auto* map :
       {&maps.jump, &maps.standard_error, &maps.level, &maps.drift_before, &maps.drift_after, &maps.residual})
    map->resize(pixels);
  const double spread = std::sqrt(sides.variance()), late = maps.time_error;
  const auto& [before, after] = sides.side;
  bool changes = false;
  for (std::size_t p = 0; p < pixels; ++p) {
    const double level = sums[0].base(p) + sums[0].at(before.height, p),
                 then = sums[1].base(p) + sums[1].at(after.height, p);
    const double left = sums[0].squares(p) + sums[1].squares(p) - sums[0].explained(p) - sums[1].explained(p);
    const double noise = std::sqrt(std::max(left, 0.0) / sides.freedom());
    maps.level[p] = static_cast<float>(level);
    maps.jump[p] = static_cast<float>(then - level);
    maps.drift_before[p] = static_cast<float>(sums[0].at(before.slope, p));
    maps.drift_after[p] = static_cast<float>(sums[1].at(after.slope, p));
    maps.residual[p] = static_cast<float>(std::isfinite(left) ? noise : left);
    const double by_time =
        late * (static_cast<double>(maps.drift_after[p]) - static_cast<double>(maps.drift_before[p]));
    maps.standard_error[p] = static_cast<float>(std::hypot(static_cast<double>(maps.residual[p]) * spread, by_time));
    changes =
        changes || sums[0].squares(p) > 0 || sums[1].squares(p) > 0 || std::abs(sums[0].base(p) - sums[1].base(p)) > 0;
  }
  if (!changes) throw InputError(without_change);
}

/// The step of the load, and where else the level of the pixels jumps, s.
struct StepsFound {
  StepGap rise;
  StepSides sides;
  std::vector<double> jumps;
};

/// A camera's level jumps in all pixels alike: where that is the larger jump, the other one is the load's.
StepsFound steps_found(const Matrix& series, const std::vector<double>& time, StepGap rise, const StepOptions& o) {
  constexpr double alike = 0.9, clearly = 0.25;
  const auto at = [&](const StepGap& gap) { return o.time ? *o.time : gap.middle; };
  StepSides sides = step_sides(series, time, at(rise), rise, o);
  std::vector<StepGap> others = other_steps(series, time, sides);
  if (others.empty()) return {rise, std::move(sides), {}};
  const auto uneven = [&](const StepSides& there) { return 1 - share_alike(jumps_at(series, there)); };
  if (const double here = uneven(sides); !o.time && here < 1 - alike)
    for (StepGap& other : others)
      if (here < clearly * uneven(step_sides(series, time, other.middle, other, o, {rise.middle}))) {
        std::swap(rise, other);
        break;
      }
  const auto jumps = mapped(others, [](const StepGap& gap) { return gap.middle; });
  return {rise, step_sides(series, time, at(rise), rise, o, jumps), jumps};
}

/// The first frame that is not before a time within the film.
std::size_t frame_at(const std::vector<double>& time, double at) {
  return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), at) - time.begin());
}

}  // namespace

StepMaps step_load(FilmSource& film, const StepOptions& o) {
  check(o);
  const std::vector<double> time = frame_times(film.info());
  if (o.time && !(*o.time > time.front() && *o.time < time.back()))
    throw refusal("the step at {:.6g} s is not within the film, which lasts {:.6g} s", *o.time, time.back());
  bool stopped = false;
  const Matrix some = some_pixels(film, [&](double share) {
    stopped = o.progress && !o.progress(share / 2);
    return !stopped;
  });
  if (stopped) return {};
  if (may_lack_frames(some))
    if (const auto lost = blank_frames(film); !lost.empty()) {
      FilmWithout kept(film, lost, time);
      StepMaps maps = of_other_frames(lost, [&] { return step_load(kept, o); });
      maps.blank = lost;
      return maps;
    }
  const Matrix series = changing_pixels(some);
  if (series.rows() == 0) throw InputError(without_change);
  const std::size_t split = o.time ? frame_at(time, *o.time) : find_step(series, time, o.drift_order);
  const StepsFound found = steps_found(series, time, find_rise(series, time, split), o);
  const StepGap& rise = found.rise;
  const StepSides& sides = found.sides;
  const double step = o.time ? *o.time : rise.middle;
  if (!o.time && !is_a_step(sides, time.size()))
    throw InputError(
        "the film shows no step of the load: nowhere do its pixels jump by more than their noise; give the time of the "
        "step");
  const auto& [before, after] = sides.side;
  StepMaps maps{film.info().width, film.info().height, step, before.count, after.count, {}, o.drift_order,
                before.relaxation, after.relaxation};
  maps.rise = rise.end > rise.first ? time[rise.end] - time[rise.first - 1] : 0;
  maps.time_error = o.time ? 0 : (time[rise.end] - time[rise.end - 1]) / std::sqrt(12.0);
  maps.doubts = step_doubts(time, rise, sides, found.jumps, o);
  maps.level_jumps = found.jumps;
  StepSums sums[2] = {StepSums(film.info().pixels(), before.height.rows()),
                      StepSums(film.info().pixels(), after.height.rows())};
  const ThreadPool pool(o.threads);
  std::size_t read = 0;
  const auto progress = [&](std::size_t frames) {
    read += frames;
    return !o.progress || o.progress((1 + static_cast<double>(read) / static_cast<double>(sides.frames())) / 2);
  };
  if (!sums[0].pass(film, before, pool, progress) || !sums[1].pass(film, after, pool, progress)) return {};
  fill(maps, sides, sums);
  return maps;
}

}  // namespace arenite::thermography
