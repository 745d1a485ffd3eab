#include "thermal/thermography/step/step_rise.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/median.hpp"
#include "thermal/thermography/harmonic_fit.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

/// Mean of the `count` frames from `first` on, of every pixel.
std::vector<double> mean_of(const Matrix& series, std::size_t first, std::size_t count) {
  std::vector<double> mean(series.rows());
  for (std::size_t n = first; n < first + count; ++n)
    for (std::size_t i = 0; i < mean.size(); ++i) mean[i] += series(i, n) / static_cast<double>(count);
  return mean;
}

/// All pixels together along the pattern of the step, by how much of it has been done: about 0 before and 1 after.
std::vector<double> along_step(const Matrix& series, std::size_t split) {
  constexpr std::size_t most = 64;
  const std::size_t frames = series.columns(), before = std::min(split, most), after = std::min(frames - split, most);
  const std::vector<double> low = mean_of(series, split - before, before), high = mean_of(series, split, after);
  std::vector<double> done(frames);
  double square = 0;
  for (std::size_t i = 0; i < low.size(); ++i) square += (high[i] - low[i]) * (high[i] - low[i]);
  if (!(square > 0)) return {};
  for (std::size_t n = 0; n < frames; ++n)
    for (std::size_t i = 0; i < low.size(); ++i) done[n] += (series(i, n) - low[i]) * (high[i] - low[i]) / square;
  return done;
}

/// How many frames of one side, its nearest to the step first, are on their way to the level of those that follow.
std::size_t frames_on_the_way(const std::vector<double>& level) {
  constexpr std::size_t shortest = 2, longest = 32, quiet = 3;
  constexpr double clear = 5, least = 0.02;  // deviations; share of the step
  std::vector<double> sum(level.size() + 1);
  std::partial_sum(level.begin(), level.end(), sum.begin() + 1);
  const auto rises_by = [&](std::size_t n, std::size_t next) {
    return (sum[n + 1 + next] - sum[n + 1]) / static_cast<double>(next) - level[n];
  };
  std::size_t on_the_way = 0;
  for (std::size_t next = shortest; next <= longest && 4 * next < level.size(); next *= 2) {
    std::vector<double> elsewhere;
    for (std::size_t n = level.size() / 4; n + next < level.size(); ++n) elsewhere.push_back(rises_by(n, next));
    const double usual = median(elsewhere);
    const double spread = 1.4826 * median(mapped(elsewhere, [&](double v) { return std::abs(v - usual); }));
    const double bound = std::max(0.0, usual) + std::max(least, clear * spread);
    std::size_t last = 0;
    for (std::size_t n = 0; n < last + quiet && n < level.size() / 4; ++n)
      if (rises_by(n, next) > bound) last = n + 1;
    on_the_way = std::max(on_the_way, last);
  }
  return on_the_way;
}

/// Sums over frames so far: of products of polynomials, and of every pixel's values with them.
struct Side {
  Matrix normal, value;

  Side(std::size_t size, std::size_t pixels) : normal(size, size), value(size, pixels) {}
  void add(const double* phi, const double* frame, double sign) {
    for (std::size_t j = 0; j < normal.rows(); ++j)
      for (std::size_t k = 0; k < normal.rows(); ++k) normal(j, k) += sign * phi[j] * phi[k];
    for (std::size_t p = 0; p < value.columns(); ++p)
      for (std::size_t k = 0; k < value.rows(); ++k) value(k, p) += sign * frame[p] * phi[k];
  }
  double explained() const {
    return statistics::dot(solve_symmetric(normal, value).column(0), value.column(0), value.size());
  }
};

}  // namespace

std::size_t find_step(const Matrix& series, const std::vector<double>& time, int drift_order) {
  const std::size_t frames = time.size(), size = static_cast<std::size_t>(drift_order) + 1, margin = size + 2;
  if (frames < 2 * margin)
    throw InputError("the film has too few frames for a step to be found; give its time, or a lower drift order");
  const double middle = (time.front() + time.back()) / 2, half = (time.back() - time.front()) / 2;
  Matrix phi(size, frames);
  for (std::size_t n = 0; n < frames; ++n) legendre((time[n] - middle) / half, size, phi.column(n));
  Side before(size, series.rows()), after = before;
  for (std::size_t n = 0; n < frames; ++n) after.add(phi.column(n), series.column(n), 1);
  std::size_t best = 0;
  double most = -1;
  for (std::size_t n = 0; n + margin <= frames; ++n) {
    if (n >= margin)
      if (const double explained = before.explained() + after.explained(); explained > most) most = explained, best = n;
    before.add(phi.column(n), series.column(n), 1);
    after.add(phi.column(n), series.column(n), -1);
  }
  return best;
}

StepGap find_rise(const Matrix& series, const std::vector<double>& time, std::size_t split) {
  const auto at = static_cast<std::ptrdiff_t>(split);
  const std::vector<double> done = along_step(series, split);
  if (done.empty()) return {split, split, (time[split - 1] + time[split]) / 2};
  std::vector<double> after(done.begin() + at, done.end()), before(done.rend() - at, done.rend());
  for (double& level : before) level = -level;
  const StepGap gap{split - frames_on_the_way(before), split + frames_on_the_way(after), 0};
  const auto median_in = [&](std::size_t from, std::size_t to) {
    return median(
        std::vector(done.begin() + static_cast<std::ptrdiff_t>(from), done.begin() + static_cast<std::ptrdiff_t>(to)));
  };
  const double low = median_in(gap.first - std::min<std::size_t>(gap.first, 5), gap.first);
  const double high = median_in(gap.end, std::min(gap.end + 5, done.size()));
  const auto share = [&](std::size_t n) {
    return n < gap.first ? 0 : n >= gap.end ? 1 : std::clamp((done[n] - low) / (high - low), 0.0, 1.0);
  };
  double middle = time[gap.end];  // less the area under the rise
  for (std::size_t n = gap.first; n <= gap.end; ++n) middle -= (share(n - 1) + share(n)) / 2 * (time[n] - time[n - 1]);
  return {gap.first, gap.end, middle};
}

}  // namespace arenite::thermography
