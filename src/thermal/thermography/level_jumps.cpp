#include "thermal/thermography/level_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

constexpr std::size_t most_jumps = 16;
constexpr double common_errors = 6;     // standard errors from which on all pixels jump
constexpr double pattern_square = 2.5;  // and mean square of each pixel's own jump over that of noise
constexpr double wild_square = 16;      // no pixel counts for more, for one that blinks jumps by itself

/// Standard deviation of normal numbers by their median size, whatever a few others are.
double robust_deviation(std::vector<double> values) {
  for (double& v : values) v = std::abs(v);
  return median(std::move(values)) / median_of_normal_size;
}

double mean_of_place(const Matrix& value, std::size_t n) {
  return std::accumulate(value.column(n), value.column(n + 1), 0.0) / static_cast<double>(value.rows());
}

/// Weights by which the differences between the k-th frames after and before a place give the step there, beside odd
/// powers and harmonics of `turns` cycles a frame: what is even about the place is the same on both sides.
std::vector<double> step_weights(std::size_t frames, double turns, std::size_t harmonics) {
  constexpr std::size_t powers = 3;
  Matrix odd(frames, 1 + powers + harmonics);
  for (std::size_t k = 0; k < frames; ++k) {
    const double later = static_cast<double>(k) + 0.5, x = later / static_cast<double>(frames);
    odd(k, 0) = 0.5;
    for (std::size_t p = 0; p < powers; ++p) odd(k, 1 + p) = std::pow(x, 2 * static_cast<double>(p) + 1);
    for (std::size_t h = 1; h <= harmonics; ++h)
      odd(k, powers + h) = std::sin(2 * std::numbers::pi * static_cast<double>(h) * turns * later);
  }
  const Matrix fit = solve_symmetric(transposed_times(odd, odd), transposed(odd));
  std::vector<double> weight(frames);
  for (std::size_t k = 0; k < frames; ++k) weight[k] = 0.5 * fit(0, k);
  return weight;
}

/// Steps of n neighbouring pixels before a frame, of which the first frame's are at `frame`.
template <std::size_t n>
void steps_before(const double* frame, std::size_t pixels, const std::vector<double>& weight, double* step) {
  double sum[n] = {};
  const double *after = frame, *before = frame - pixels;
  for (const double w : weight) {
    for (std::size_t i = 0; i < n; ++i) sum[i] += w * (after[i] - before[i]);
    after += pixels, before -= pixels;
  }
  std::copy_n(sum, n, step);
}

/// Steps of every pixel before some frames: pixels x places.
Matrix steps_of(const Matrix& value, const std::vector<double>& weight, const std::vector<std::size_t>& places,
                const ThreadPool& pool) {
  constexpr std::size_t some = 8;  // whose sums stay in registers
  const std::size_t pixels = value.rows();
  Matrix step(pixels, places.size());
  pool.for_each(places.size(), [&](std::size_t m) {
    const double* const frame = value.column(places[m]);
    std::size_t i = 0;
    for (; i + some <= pixels; i += some) steps_before<some>(frame + i, pixels, weight, step.column(m) + i);
    for (; i < pixels; ++i) steps_before<1>(frame + i, pixels, weight, step.column(m) + i);
  });
  return step;
}

/// How far pixels step in noise: all together, and each beside that.
struct StepNoise {
  double common = 0;
  std::vector<double> own;

  /// By those columns of the steps that are `used`.
  StepNoise(const Matrix& step, const std::vector<std::size_t>& used, double least, const ThreadPool& pool)
      : own(step.rows()) {
    std::vector<double> mean;
    for (const std::size_t m : used) mean.push_back(mean_of_place(step, m));
    pool.for_each(own.size(), [&](std::size_t i) {
      std::vector<double> rest(used.size());
      for (std::size_t m = 0; m < rest.size(); ++m) rest[m] = step(i, used[m]) - mean[m];
      own[i] = std::max(robust_deviation(std::move(rest)), least);
    });
    common = std::max(robust_deviation(std::move(mean)), least / common_errors);
  }
};

/// The pixels' steps at one place against their noise.
struct StepHere {
  double common = 0, own = 0;  ///< mean and standard deviation beyond noise; 0 where noise explains it
  double clear = 0;            ///< above 1 where noise does not explain them

  StepHere(const Matrix& step, std::size_t place, const StepNoise& noise) {
    const double mean = mean_of_place(step, place), pixels = static_cast<double>(step.rows());
    double pattern = 0, excess = 0;
    for (std::size_t i = 0; i < step.rows(); ++i) {
      const double square = std::pow(step(i, place) - mean, 2), usual = noise.own[i] * noise.own[i];
      pattern += (usual > 0 ? std::min(square / usual, wild_square) : 0) / pixels, excess += (square - usual) / pixels;
    }
    const double together = std::abs(mean) / (common_errors * noise.common);
    clear = std::max(together, pattern / pattern_square);
    common = together > 1 ? mean : 0, own = pattern > pattern_square ? std::sqrt(std::max(0.0, excess)) : 0;
  }
};

/// The clearest jumps, none nearer than the weights reach to another: first at some frames, then between these.
void add_jumps(const Matrix& value, const std::vector<double>& weight, double least, const ThreadPool& pool,
               std::vector<LevelJump>& jumps) {
  const std::size_t reach = weight.size(), every = std::max<std::size_t>(1, reach / 32);
  std::vector<std::size_t> places;
  for (std::size_t n = reach; n + reach <= value.columns(); n += every) places.push_back(n);
  const Matrix step = steps_of(value, weight, places, pool);
  const auto taken = [&](std::size_t n) {
    return std::ranges::any_of(jumps,
                               [&](const LevelJump& j) { return std::max(j.frame, n) - std::min(j.frame, n) < reach; });
  };
  while (jumps.size() < most_jumps) {
    std::vector<std::size_t> used;  // where jumps that are known do not reach
    for (std::size_t m = 0; m < places.size(); ++m)
      if (!taken(places[m])) used.push_back(m);
    if (used.size() < 8) return;
    const StepNoise noise(step, used, least, pool);
    if (!(noise.common > 0)) return;
    const auto clear = mapped(used, [&](std::size_t m) { return StepHere(step, m, noise).clear; });
    const auto best = std::ranges::max_element(clear);
    if (!(*best > 1)) return;
    const std::size_t about = places[used[static_cast<std::size_t>(best - clear.begin())]];
    std::vector<std::size_t> near;
    for (std::size_t n = std::max(reach, about - every); n <= about + every; ++n)
      if (n + reach <= value.columns() && !taken(n)) near.push_back(n);
    const Matrix closer = steps_of(value, weight, near, pool);
    std::size_t at = 0;
    for (std::size_t m = 1; m < near.size(); ++m)
      if (StepHere(closer, m, noise).clear > StepHere(closer, at, noise).clear) at = m;
    const StepHere here(closer, at, noise);
    jumps.push_back({near[at], here.common, here.own});
  }
}

}  // namespace

std::vector<LevelJump> level_jumps(const Matrix& left, double cycle, std::size_t harmonics, double least,
                                   const ThreadPool& pool) {
  std::vector<LevelJump> jumps;
  for (const double cycles : {2.0, 1.0}) {  // shorter reaches see nearer to the ends, but less
    const auto reach = std::max<std::size_t>(12, static_cast<std::size_t>(std::lround(cycles * cycle)));
    if (left.columns() >= 4 * reach) add_jumps(left, step_weights(reach, 1 / cycle, harmonics), least, pool, jumps);
  }
  std::ranges::sort(jumps, {}, &LevelJump::frame);
  return jumps;
}

}  // namespace arenite::thermography
