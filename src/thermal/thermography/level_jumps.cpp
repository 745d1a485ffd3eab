#include "thermal/thermography/level_jumps.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "thermal/thermography/kernels/kernels.hpp"

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

/// Steps of every pixel before some frames, pixels x places, and their means over the pixels.
struct Steps {
  Matrix step;
  std::vector<double> mean;

  Steps(const Matrix& value, const std::vector<double>& weight, const std::vector<std::size_t>& places,
        const ThreadPool& pool)
      : step(value.rows(), places.size()),
        mean(places.size()) {
    pool.for_each(places.size(), [&](std::size_t m) {
      kernels().steps(value.column(places[m]), value.rows(), weight.data(), weight.size(), step.column(m));
      mean[m] = std::accumulate(step.column(m), step.column(m + 1), 0.0) / static_cast<double>(step.rows());
    });
  }
};

/// How far pixels step in noise: all together, and each beside that.
struct StepNoise {
  double common = 0;
  std::vector<double> own;

  /// By those places that are `used`.
  StepNoise(const Steps& steps, const std::vector<std::size_t>& used, double least, const ThreadPool& pool)
      : own(steps.step.rows()) {
    pool.for_each(own.size(), [&](std::size_t i) {
      own[i] = std::max(robust_deviation(mapped(used, [&](std::size_t m) { return steps.step(i, m) - steps.mean[m]; })),
                        least);
    });
    common =
        std::max(robust_deviation(mapped(used, [&](std::size_t m) { return steps.mean[m]; })), least / common_errors);
  }
};

/// The pixels' steps at one place against their noise.
struct StepHere {
  double common = 0, own = 0;  ///< mean and standard deviation beyond noise; 0 where noise explains it
  double clear = 0;            ///< above 1 where noise does not explain them

  StepHere(const Steps& steps, std::size_t place, const StepNoise& noise) {
    const double mean = steps.mean[place], pixels = static_cast<double>(steps.step.rows());
    double pattern = 0, excess = 0;
    for (std::size_t i = 0; i < steps.step.rows(); ++i) {
      const double square = std::pow(steps.step(i, place) - mean, 2), usual = noise.own[i] * noise.own[i];
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
  // Places nearer to each other share so many frames that they tell nothing more of the noise.
  const std::size_t apart = std::max<std::size_t>(1, reach / 16 / every);
  std::vector<std::size_t> places;
  for (std::size_t n = reach; n + reach <= value.columns(); n += every) places.push_back(n);
  const Steps steps(value, weight, places, pool);
  const auto taken = [&](std::size_t n) {
    return std::ranges::any_of(jumps,
                               [&](const LevelJump& j) { return std::max(j.frame, n) - std::min(j.frame, n) < reach; });
  };
  while (jumps.size() < most_jumps) {
    std::vector<std::size_t> used, some;  // where jumps that are known do not reach
    for (std::size_t m = 0; m < places.size(); ++m) {
      if (taken(places[m])) continue;
      if (used.size() % apart == 0) some.push_back(m);
      used.push_back(m);
    }
    if (some.size() < 8) return;
    const StepNoise noise(steps, some, least, pool);
    if (!(noise.common > 0)) return;
    std::vector<double> clear(used.size());
    pool.for_each(used.size(), [&](std::size_t k) { clear[k] = StepHere(steps, used[k], noise).clear; });
    const auto best = std::ranges::max_element(clear);
    if (!(*best > 1)) return;
    const std::size_t about = places[used[static_cast<std::size_t>(best - clear.begin())]];
    std::vector<std::size_t> near;
    for (std::size_t n = std::max(reach, about - every); n <= about + every; ++n)
      if (n + reach <= value.columns() && !taken(n)) near.push_back(n);
    const Steps closer(value, weight, near, pool);
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
