#include "thermal/thermography/segment_sums.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "core/median.hpp"
#include "core/option.hpp"
#include "core/problems.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/level_changes.hpp"

namespace arenite::thermography {
namespace {

std::size_t segment_count(std::size_t frames, double cycles, int drift_order) {
  const auto by_cycles = static_cast<std::size_t>(std::clamp(cycles / 16, 16.0, 64.0));
  // In few cycles drift and load are all but alike, and only fine segments tell them apart as well as single frames do.
  const auto needed = std::max<std::size_t>(3 * static_cast<std::size_t>(drift_order + 1), cycles < 4 ? 32 : 0);
  return std::min(frames, std::max(needed, std::min(frames / 8, by_cycles)));
}

/// Into so many segments, or one or two more: a jump of the level ends one of them.
void cut(SegmentSums& s, std::size_t count, const std::vector<LevelJump>& jumps) {
  const std::size_t frames = s.time.size();
  for (std::size_t k = 0; k <= count; ++k) {
    const std::size_t at = frames * k / count;
    const auto replaced = [&](const LevelJump& j) {
      return 2 * (std::max(j.frame, at) - std::min(j.frame, at)) * count < frames;
    };
    if (k == 0 || k == count || std::ranges::none_of(jumps, replaced)) s.first.push_back(at);
  }
  for (const LevelJump& j : jumps) s.first.push_back(j.frame);
  std::ranges::sort(s.first);
  for (std::size_t k = 0; k + 1 < s.first.size(); ++k)
    s.centre.push_back((s.time[s.first[k]] + s.time[s.first[k + 1] - 1]) / 2);
}

void weigh(SegmentSums& s) {
  s.weights.resize(s.time.size() * s.functions);
  for (std::size_t k = 0; k < s.segments(); ++k)
    for (std::size_t n = s.first[k]; n < s.first[k + 1]; ++n)
      for (std::size_t h = 0; 2 * h < s.functions; ++h) {
        const double angle =
            2 * std::numbers::pi * s.frequency * static_cast<double>(h + 1) * (s.time[n] - s.centre[k]);
        s.weights[n * s.functions + 2 * h] = static_cast<float>(std::cos(angle));
        s.weights[n * s.functions + 2 * h + 1] = static_cast<float>(std::sin(angle));
      }
}

/// Some pixels, by the golden section so that no two of them lie in one row or column of a regular pattern.
void watch(SegmentSums& s) {
  constexpr std::size_t most = 32, most_values = std::size_t{1} << 24;
  const std::size_t count = std::min({s.pixels, most, std::max<std::size_t>(8, most_values / s.time.size())});
  for (std::size_t i = 0; i < count; ++i) {
    const double at = std::numbers::phi * static_cast<double>(i);
    s.watched.push_back(
        count == s.pixels ? i : static_cast<std::size_t>((at - std::floor(at)) * static_cast<double>(s.pixels)));
  }
  s.seen.resize(s.time.size() * count);
}

struct Pass {
  SegmentSums& s;
  const ThreadPool& pool;
  std::vector<float> reference;

  /// Frames first .. first + count - 1, all within segment k.
  template <class T> void add(const T* frames, std::size_t first, std::size_t count, std::size_t k) {
    const bool opens = first == s.first[k];
    const std::size_t chunks = (s.pixels + chunk - 1) / chunk;
    pool.for_ranges(chunks, [&](std::size_t from, std::size_t to) {
      const std::size_t begin = from * chunk, end = std::min(to * chunk, s.pixels);
      if (opens) refer(frames, k, begin, end);
      for (std::size_t p = begin; p < end; p += tile)
        for (std::size_t n = 0; n < count; n += group) {
          const std::size_t some = std::min(group, count - n), ahead = n + 2 * group <= count ? group * s.pixels : 0;
          add_group(
              WeighedFrames<T>{frames + n * s.pixels, s.pixels, some, s.weights.data() + (first + n) * s.functions,
                               s.functions, reference.data(), ahead},
              first + n, k, p, std::min(p + tile, end));
        }
    });
  }

  /// The watched pixels are kept while the caches still hold these frames.
  template <class T>
  void add_group(const WeighedFrames<T>& some, std::size_t first, std::size_t k, std::size_t begin, std::size_t end) {
    float* sums = s.sums.data() + s.view().at(0, k, 0);
    const std::size_t stride = s.segments() * s.planes() * chunk;
    if constexpr (sizeof(T) == 2) kernels().add_levels(some, sums, stride, begin, end);
    else kernels().add_values(some, sums, stride, begin, end);
    for (std::size_t i = 0; i < s.watched.size(); ++i)
      if (const std::size_t p = s.watched[i]; p >= begin && p < end)
        for (std::size_t n = 0; n < some.count; ++n)
          s.seen[i * s.time.size() + first + n] = static_cast<float>(some.frames[n * s.pixels + p]) - s.base[p];
  }

  template <class T> void refer(const T* frame, std::size_t k, std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) reference[p] = static_cast<float>(frame[p]);
    if (k == 0) std::copy_n(reference.data() + begin, end - begin, s.base.data() + begin);
    for (std::size_t p = begin; p < end; ++p) s.sums[s.view().at(p, k, s.planes() - 1)] = reference[p] - s.base[p];
  }
};

/// Segment by segment.
bool pass_over(SegmentSums& s, const ThreadPool& pool, FilmSource& film, const Progress& progress) {
  Pass pass{s, pool, std::vector<float>(s.pixels)};
  for (std::size_t k = 0; k < s.segments(); ++k) {
    const std::size_t first = s.first[k], count = s.first[k + 1] - first;
    const auto add = [&](const auto* frames, std::size_t n, std::size_t some) {
      pass.add(frames, first + n, some, k);
      return !progress || progress(static_cast<double>(first + n + some) / static_cast<double>(s.time.size()));
    };
    if (!read_frames(film, first, count, add)) return false;
  }
  return true;
}

}  // namespace

std::vector<double> frame_times(const FilmInfo& film) {
  const auto frames = static_cast<std::size_t>(film.frames);
  std::vector<double> time = film.time;
  if (time.empty()) {
    const double rate = film.frame_rate;
    if (!(rate > 0) || !std::isfinite(rate))
      throw InputError("the film does not state its frame rate; give it (" + option("frame-rate") +
                       ", frame_rate in [film] of a recipe or beside raw frames)");
    for (std::size_t n = 0; n < frames; ++n) time.push_back(static_cast<double>(n) / rate);
    if (film.number.size() == frames)
      std::ranges::transform(film.number, time.begin(), [&](auto n) { return static_cast<double>(n) / rate; });
  }
  if (time.size() != frames)
    throw refusal("the film has {} frames but {} time stamps; correct its stamps", frames, time.size());
  for (std::size_t n = 1; n < frames; ++n)
    if (!(time[n] > time[n - 1]) || !std::isfinite(time[n]))
      throw refusal("the time stamp of frame {} is not after that of the frame before it; correct its stamps", n);
  return time;
}

double nyquist_frequency(const std::vector<double>& time) {
  std::vector<double> step;
  for (std::size_t n = 1; n < time.size(); ++n) step.push_back(time[n] - time[n - 1]);
  if (step.empty()) return 0;
  return 0.5 / median(std::move(step));
}

SegmentSums sum_segments(FilmSource& film, std::vector<double> time, double frequency, int harmonics, int drift_order,
                         const ThreadPool& pool, const Progress& progress, const LevelChanges& changes) {
  SegmentSums s;
  s.time = std::move(time);
  s.frequency = frequency;
  s.functions = 2 * static_cast<std::size_t>(harmonics);
  s.pixels = film.info().pixels();
  const std::size_t frames = s.time.size();
  const double cycles = frequency * (s.time.back() - s.time.front());
  std::size_t segments = segment_count(frames, cycles, drift_order);
  if (!changes.course.empty()) segments = std::clamp(static_cast<std::size_t>(cycles / 1.5), segments, 2 * segments);
  cut(s, segments, changes.jumps);
  s.levels = functions_of(changes, frames);
  weigh(s);
  watch(s);
  s.base.resize(s.pixels);
  s.sums = Buffer<float>(s.view().at((s.pixels + chunk - 1) / chunk * chunk, 0, 0));
  if (!pass_over(s, pool, film, progress)) s.sums.clear();
  return s;
}

}  // namespace arenite::thermography
