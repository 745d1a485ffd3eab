#include "thermal/thermography/level_changes.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <utility>

#include "core/median.hpp"
#include "model/lockin_maps.hpp"
#include "statistics/least_squares.hpp"
#include "thermal/thermography/harmonic_fit.hpp"
#include "thermal/thermography/level_jumps.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

constexpr std::size_t most_knots = 50;

/// Watched pixels x frames, without those that do not change or are no numbers.
Matrix watched_values(const SegmentSums& s) {
  const std::size_t frames = s.time.size();
  std::vector<std::size_t> used;
  for (std::size_t i = 0; i < s.watched.size(); ++i) {
    const auto first = s.seen.begin() + static_cast<std::ptrdiff_t>(i * frames),
               end = first + static_cast<std::ptrdiff_t>(frames);
    if (std::all_of(first, end, [](float v) { return std::isfinite(v); }) &&
        std::any_of(first, end, [](float v) { return std::abs(v) > 0; }))
      used.push_back(i);
  }
  Matrix value(used.size(), frames);
  for (std::size_t n = 0; n < frames; ++n)
    for (std::size_t i = 0; i < used.size(); ++i) value(i, n) = static_cast<double>(s.seen[used[i] * frames + n]);
  return value;
}

/// Cos and sin of the first harmonic after so many cycles, then those of the second.
double harmonic(double cycles, std::size_t k) {
  const double angle = 2 * std::numbers::pi * static_cast<double>(k / 2 + 1) * cycles;
  return k % 2 == 0 ? std::cos(angle) : std::sin(angle);
}

/// Polynomials up to the order, orthonormal over the frames, then harmonics of the load and `others`: frames x
/// functions.
Matrix known_functions(const SegmentSums& s, double frequency, int order,
                       const std::vector<std::vector<double>>& others) {
  const std::size_t powers = static_cast<std::size_t>(order) + 1;
  Matrix all(s.time.size(), powers + s.functions + others.size());
  std::vector<double> legendres(powers);
  for (std::size_t n = 0; n < all.rows(); ++n) {
    legendre(2 * (s.time[n] - s.time.front()) / (s.time.back() - s.time.front()) - 1, powers, legendres.data());
    for (std::size_t k = 0; k < powers; ++k) all(n, k) = legendres[k];
    for (std::size_t k = 0; k < s.functions; ++k) all(n, powers + k) = harmonic(frequency * s.time[n], k);
    for (std::size_t k = 0; k < others.size(); ++k) all(n, powers + s.functions + k) = others[k][n];
  }
  return statistics::orthonormal(all).q;
}

/// What the functions leave of those pixels that are not far wilder than most, as one that blinks.
Matrix without(Matrix value, const Matrix& functions) {
  constexpr double wild = 4;  // times the median power
  value -= times_transposed(value * functions, functions);
  std::vector<double> power(value.rows());
  for (std::size_t n = 0; n < value.columns(); ++n)
    for (std::size_t i = 0; i < power.size(); ++i) power[i] += value(i, n) * value(i, n);
  const double most = wild * median(power);
  std::vector<std::size_t> calm(power.size());
  std::iota(calm.begin(), calm.end(), 0);
  std::erase_if(calm, [&](std::size_t i) { return power[i] > most; });
  if (calm.size() == power.size()) return value;
  Matrix left(calm.size(), value.columns());
  for (std::size_t n = 0; n < left.columns(); ++n)
    for (std::size_t k = 0; k < calm.size(); ++k) left(k, n) = value(calm[k], n);
  return left;
}

/// Root mean square of what the median pixel has of these functions.
double oscillation(const Matrix& value, const Matrix& harmonics) {
  const Matrix part = value * harmonics;
  std::vector<double> squares(value.rows());
  for (std::size_t k = 0; k < part.columns(); ++k)
    for (std::size_t i = 0; i < squares.size(); ++i) squares[i] += part(i, k) * part(i, k);
  return std::sqrt(median(std::move(squares)) / static_cast<double>(value.columns()));
}

/// Uniform cubic B-splines between so many knots over the film, then harmonics of the load and steps: frames
/// x functions.
Matrix splines(const SegmentSums& s, double frequency, std::size_t knots,
               const std::vector<std::vector<double>>& steps) {
  Matrix all(s.time.size(), knots + 3 + s.functions + steps.size());
  const double length = s.time.back() - s.time.front();
  for (std::size_t n = 0; n < all.rows(); ++n) {
    const double at = static_cast<double>(knots) * (s.time[n] - s.time.front()) / length;
    const std::size_t k = std::min(static_cast<std::size_t>(at), knots - 1);
    const double u = at - static_cast<double>(k), v = 1 - u;
    all(n, k) = v * v * v / 6;
    all(n, k + 1) = 2.0 / 3 - u * u * (1 - u / 2);
    all(n, k + 2) = 2.0 / 3 - v * v * (1 - v / 2);
    all(n, k + 3) = u * u * u / 6;
    for (std::size_t h = 0; h < s.functions; ++h) all(n, knots + 3 + h) = harmonic(frequency * s.time[n], h);
    for (std::size_t j = 0; j < steps.size(); ++j) all(n, knots + 3 + s.functions + j) = steps[j][n];
  }
  return all;
}

/// Mean square of the means of so many frames each, over what white noise would make it.
double power_of_means(const Matrix& signal, std::size_t frames) {
  double sum = 0, means = 0;
  for (std::size_t n = 0; n + frames <= signal.rows(); n += frames, ++means)
    sum += std::pow(std::accumulate(signal.column(0) + n, signal.column(0) + n + frames, 0.0), 2);
  return sum / means / static_cast<double>(frames) / (squares(signal) / static_cast<double>(signal.rows()));
}

/// What all pixels share that the known functions do not follow and that is far slower than 1/f noise: a curve through
/// knots that lie a cycle apart or farther, too few to follow the load. Empty where there is none.
std::vector<double> course_of(const SegmentSums& s, const Matrix& left, const Matrix& known, double frequency,
                              int order, double least, const std::vector<std::vector<double>>& steps) {
  constexpr double steeper = 2, least_power = 20;
  const auto frames = static_cast<double>(s.time.size()), first = 0.5 * (order + 1);
  const double cycles = frequency * (s.time.back() - s.time.front());
  const std::size_t knots = std::min(most_knots, static_cast<std::size_t>(cycles));
  if (knots < static_cast<std::size_t>(order) + 6) return {};
  Matrix common(s.time.size(), 1);
  for (std::size_t n = 0; n < common.rows(); ++n)
    common(n, 0) = std::accumulate(left.column(n), left.column(n + 1), 0.0) / static_cast<double>(left.rows());
  const double cycle = std::ceil(frames / cycles);
  if (power_of_means(common, static_cast<std::size_t>(cycle)) < std::min(least_power / 5, cycle / 2)) return {};
  const Matrix basis = splines(s, frequency, knots, steps);
  const Matrix part = solve_symmetric(transposed_times(basis, basis), transposed_times(basis, common));
  Matrix rest = common, curve(common.rows(), 1);
  rest -= basis * part;
  for (std::size_t n = 0; n < curve.rows(); ++n)
    for (std::size_t k = 0; k < knots + 3; ++k) curve(n, 0) += basis(n, k) * part(k, 0);
  // Of the known functions harmonics stay: what the curve has of them is not the load's.
  const std::size_t powers = static_cast<std::size_t>(order) + 1;
  const Matrix slow = known.part(0, powers);
  curve -= slow * transposed_times(slow, curve);
  const double freedom = static_cast<double>(knots) - order,
               noise = squares(rest) / (frames - static_cast<double>(basis.columns()));
  const double power = squares(curve) / freedom / noise;
  // Of 1/f noise the mean power between the polynomials and the knots, over that beyond them.
  const double last = 0.5 * static_cast<double>(knots), nyquist = 0.5 * frames;
  const double flicker = std::log(last / first) / (last - first) / (std::log(nyquist / last) / (nyquist - last));
  if (!(power > std::max(least_power, steeper * flicker)) || squares(curve) < frames * least * least) return {};
  return {curve.column(0), curve.column(1)};
}

}  // namespace

LevelChanges find_level_changes(const SegmentSums& s, double frequency, int order, const ThreadPool& pool) {
  constexpr double least_cycles = 8, least_share = 0.01;  // of the oscillation: less is of no consequence to it
  constexpr std::size_t least_pixels = 4;
  const double cycle = 2 * nyquist_frequency(s.time) / frequency;
  if (frequency * (s.time.back() - s.time.front()) < least_cycles || s.time.size() < 100) return {};
  const Matrix value = watched_values(s);
  if (value.rows() < least_pixels) return {};
  LevelChanges found;
  const Matrix usual = known_functions(s, frequency, order, {});
  const double least = least_share * oscillation(value, usual.part(static_cast<std::size_t>(order) + 1, s.functions));
  const Matrix left = without(value, usual);
  found.jumps = level_jumps(left, cycle, s.functions / 2, least, pool);
  const auto steps = functions_of(found, s.time.size());
  const Matrix known = steps.empty() ? usual : known_functions(s, frequency, order, steps);
  found.course = course_of(s, steps.empty() ? left : without(value, known), known, frequency, order, least, steps);
  return found;
}

std::vector<std::vector<double>> functions_of(const LevelChanges& changes, std::size_t frames) {
  std::vector<std::vector<double>> all;
  for (const LevelJump& jump : changes.jumps) {
    const double after = static_cast<double>(frames - jump.frame) / static_cast<double>(frames);
    auto& step = all.emplace_back(frames, -after);
    for (std::size_t n = jump.frame; n < frames; ++n) step[n] += 1;
  }
  if (!changes.course.empty()) all.push_back(changes.course);
  return all;
}

}  // namespace arenite::thermography
