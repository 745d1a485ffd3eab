#include "thermal/thermography/step/step_sides.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "core/problems.hpp"
#include "core/root.hpp"

namespace arenite::thermography {
namespace {

using statistics::Matrix;

/// Pixels that vary independently, from the mean square correlation of pairs less what chance gives it (Bartlett).
double independent_pixels(const Matrix& residual, const std::vector<double>& lag) {
  const std::size_t all = residual.rows(), every = std::max<std::size_t>(1, all / 128),
                    count = (all + every - 1) / every;
  if (count < 2) return 1;
  Matrix some(count, residual.columns());
  for (std::size_t n = 0; n < some.columns(); ++n)
    for (std::size_t i = 0; i < count; ++i) some(i, n) = residual(i * every, n);
  const Matrix pairs = times_transposed(some, some);
  double squares = 0;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t j = 0; j < count; ++j)
      if (pairs(i, i) > 0 && pairs(j, j) > 0) squares += pairs(i, j) * pairs(i, j) / (pairs(i, i) * pairs(j, j));
  const auto n = static_cast<double>(count);
  double chance = 1;
  for (const double r : lag) chance += 2 * r * r;
  const double square = (squares - n) / (n * (n - 1)) - chance / static_cast<double>(residual.columns());
  return static_cast<double>(all) / (1 + (static_cast<double>(all) - 1) * std::max(square, 0.0));
}

/// Sums over rows of products of values so many frames apart, of columns that are frames.
std::vector<double> products(const Matrix& value, std::size_t lags) {
  std::vector<double> sums;
  for (std::size_t k = 1; k <= lags; ++k)
    sums.push_back(statistics::dot(value.column(0), value.column(k), value.rows() * (value.columns() - k)));
  return sums;
}

/// Of pixels x frames, left by a fit of the functions `fitted` (functions x frames, orthonormal), which takes some
/// correlation with it.
ResidualCorrelation residual_correlation(const Matrix& residual, const Matrix& fitted) {
  ResidualCorrelation result;
  const auto frames = static_cast<double>(residual.columns()), functions = static_cast<double>(fitted.rows());
  const double all = squares(residual);
  if (!(all > 0)) return result;
  const std::size_t lags = residual.columns() / 4;
  const std::vector<double> seen = products(residual, lags), taken = products(fitted, lags);
  const double lost_in_noise = std::max(1e-3, 2 / std::sqrt(frames * independent_pixels(residual, {})));
  double sum = 1;
  // In white noise the fit takes just this from each lag; of correlated noise, strongest where the fit is, as much more
  // (Marriott and Pope 1954).
  for (int turn = 0; turn < 8; ++turn) {
    result.lag.clear();
    double next = 1;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double r = seen[k] / all + sum * taken[k] / (frames - functions);
      if (r < lost_in_noise) break;
      result.lag.push_back(std::min(r, 0.999));
      next += 2 * result.lag.back();
    }
    sum = std::min(next, frames / (4 * functions + 4));
  }
  result.pixels = independent_pixels(residual, result.lag);
  return result;
}

/// Where a side lies: its frames.
struct Place {
  const std::vector<double>& time;
  double step;
  int order;
  std::size_t first, end;
  std::vector<double> jumps = {};  ///< s, well within it

  std::size_t count() const { return end - first; }
  double length() const { return std::max(std::abs(time[first] - step), std::abs(time[end - 1] - step)); }
  /// An exponential falls from where the side begins.
  double since(double t) const { return t - std::min(step, time[first]); }
};

/// `with_time` adds the function by which the fit changes when the relaxation's time does.
StepSide side_of(const Place& at, double relaxation, bool with_time = false) {
  const std::size_t powers = static_cast<std::size_t>(at.order) + 1, levels = powers + at.jumps.size(),
                    size = levels + (relaxation > 0 ? 1 : 0) + (with_time ? 1 : 0);
  const double length = at.length();
  Matrix value(size, 1), slope = value;
  const auto functions = [&](double t) {
    const double x = (t - at.step) / length;
    for (std::size_t k = 0; k < powers; ++k) {
      value(k, 0) = k == 0 ? 1 : value(k - 1, 0) * x;
      slope(k, 0) = k == 0 ? 0 : static_cast<double>(k) * value(k - 1, 0) / length;
    }
    for (std::size_t k = powers; k < levels; ++k) value(k, 0) = t >= at.jumps[k - powers] ? 1 : 0, slope(k, 0) = 0;
    if (relaxation <= 0) return;
    const double since = at.since(t), fall = std::exp(-since / relaxation);
    value(levels, 0) = fall, slope(levels, 0) = -fall / relaxation;
    if (with_time)
      value(levels + 1, 0) = since / length * fall, slope(levels + 1, 0) = (1 - since / relaxation) / length * fall;
  };
  Matrix all(at.count(), size);
  for (std::size_t n = 0; n < all.rows(); ++n) {
    functions(at.time[at.first + n]);
    for (std::size_t k = 0; k < size; ++k) all(n, k) = value(k, 0);
  }
  auto [q, r] = statistics::orthonormal(all);
  functions(at.step);
  for (double* each :
       {value.column(0), slope.column(0)})  // the functions at the step from those that are orthonormal, by r^T
    for (std::size_t k = 0; k < size; ++k) {
      for (std::size_t j = 0; j < k; ++j) each[k] -= r(j, k) * each[j];
      each[k] /= r(k, k);
    }
  return {at.first, at.count(), relaxation, std::move(q), value, slope};
}

Matrix left_by(const Matrix& series, const StepSide& side) {
  Matrix value = series.part(side.first, side.count);
  return value -= times_transposed(value * side.weight, side.weight);
}

/// Weights of all frames for the last function's number: one column.
Matrix last_function(const StepSide& side) { return side.weight.part(side.weight.columns() - 1, 1); }

/// The time in which all pixels together relax best: on a ladder of times, then between its rungs. Within fewer frames
/// than ten nothing tells heat that flows from a load that is still on its way.
double best_relaxation(const Matrix& series, const Place& at) {
  constexpr double rung = 1.25;
  const double shortest = 10 * at.length() / static_cast<double>(at.count());
  const StepSide plain = side_of(at, 0);
  const Matrix rest = left_by(series, plain);
  const auto explained = [&](double log_time) {
    return squares(rest * last_function(side_of(at, std::exp(log_time))));
  };
  double best = std::log(shortest), most = -1;
  for (double t = std::log(shortest); t <= std::log(at.length()); t += std::log(rung))
    if (const double e = explained(t); e > most) most = e, best = t;
  return std::exp(minimum_between([&](double log_time) { return -explained(log_time); }, best - std::log(rung),
                                  best + std::log(rung)));
}

/// The side with or without the exponential; what is left of one that is not sure is an error. Its functions are
/// orthonormal, so that the squares of the frames' weights for the height add up to those of the height itself.
StepSide choose(const Matrix& series, const Place& at, const StepSide& relaxing, const ResidualCorrelation& noise,
                double variance) {
  StepSide plain = side_of(at, 0);
  const Matrix more = last_function(relaxing);
  const double widening = noise.widening(more);
  const double explained =
      squares(series.part(at.first, at.count()) * more) / static_cast<double>(series.rows()) / variance / widening;
  if (explained > chi_squared_above(noise.pixels, 4)) {
    StepSide side = relaxing;
    side.misfit =
        std::max(0.0, squares(side_of(at, relaxing.relaxation, true).height) - squares(relaxing.height)) / noise.pixels;
    return side;
  }
  const double wider = squares(relaxing.height) - squares(plain.height);
  plain.misfit =
      std::max(0.0, wider) * widening * std::max(0.0, explained - std::min(2.0, chi_squared_above(noise.pixels, 3)));
  return plain;
}

/// Divides every pixel by what the polynomials leave of it; one of which they leave nothing says nothing of the noise.
void weigh(Matrix& series, const std::array<Place, 2>& places) {
  std::vector<double> factor(series.rows());
  const auto frames = static_cast<double>(places[0].count() + places[1].count());
  for (const Place& at : places) {
    const Matrix left = left_by(series, side_of(at, 0));
    for (std::size_t n = 0; n < left.columns(); ++n)
      for (std::size_t i = 0; i < factor.size(); ++i) factor[i] += left(i, n) * left(i, n) / frames;
  }
  for (double& f : factor) f = f > 0 ? 1 / std::sqrt(f) : 0;
  for (std::size_t n = 0; n < series.columns(); ++n)
    for (std::size_t i = 0; i < factor.size(); ++i) series(i, n) *= factor[i];
}

/// Of every pixel, at the step.
Matrix heights(const Matrix& series, const StepSide& side) {
  return series.part(side.first, side.count) * side.height_weights();
}

/// Variance of what the sides leave of the pixels, whose correlation becomes their noise.
double measure_noise(const Matrix& series, StepSides& sides) {
  Matrix left(series.rows(), sides.frames()), fitted(sides.functions(), sides.frames());
  std::size_t at = 0, row = 0;
  for (const StepSide& side : sides.side) {
    const Matrix of_side = left_by(series, side);
    std::copy_n(of_side.column(0), of_side.size(), left.column(at));
    for (std::size_t n = 0; n < side.count; ++n)
      for (std::size_t j = 0; j < side.height.rows(); ++j) fitted(row + j, at + n) = side.weight(n, j);
    at += side.count, row += side.height.rows();
  }
  sides.noise = residual_correlation(left, fitted);
  return squares(left) / static_cast<double>(left.rows()) / sides.freedom();
}

std::array<Place, 2> places_of(const std::vector<double>& time, double step, const StepGap& gap, const StepOptions& o,
                               const std::vector<double>& jumps) {
  const double far = o.window > 0 ? o.window : time.back() + 1;
  const auto from = [&](double t) {
    return static_cast<std::size_t>(std::lower_bound(time.begin(), time.end(), t) - time.begin());
  };
  const auto after = [&](double t) {
    return static_cast<std::size_t>(std::upper_bound(time.begin(), time.end(), t) - time.begin());
  };
  std::array places{Place{time, step, o.drift_order, from(step - far), std::min(gap.first, from(step - o.rise / 2))},
                    Place{time, step, o.drift_order, std::max(gap.end, after(step + o.rise / 2)), after(step + far)}};
  for (const Place& at : places)
    if (at.end < at.first + static_cast<std::size_t>(o.drift_order) + 3)
      throw refusal(
          "the film has {} frames {} the step at {:.6g} s that can be used, too few for a drift of order {}; give "
          "another time, a longer window, a shorter rise or less drift",
          at.end > at.first ? at.count() : 0, &at == places.data() ? "before" : "after", step, o.drift_order);
  constexpr std::size_t least_frames = 8;  // on both sides of a jump
  for (Place& at : places)
    for (const double jump : jumps)
      if (at.count() > 2 * least_frames && jump > time[at.first + least_frames] &&
          jump < time[at.end - 1 - least_frames])
        at.jumps.push_back(jump);
  return places;
}

}  // namespace

double ResidualCorrelation::widening(const Matrix& weight) const {
  double sum = squares(weight);
  const double* w = weight.column(0);
  for (std::size_t k = 1; k <= lag.size() && k < weight.rows(); ++k)
    sum += 2 * lag[k - 1] * statistics::dot(w, w + k, weight.rows() - k);
  return std::max(sum / squares(weight), 1.0);
}

double chi_squared_above(double numbers, double deviations) {
  const double variance = 2 / (9 * numbers);
  return std::pow(1 - variance + deviations * std::sqrt(variance), 3);
}

double StepSides::variance() const {
  Matrix weight(frames(), 1);
  const Matrix low = side[0].height_weights(), high = side[1].height_weights();
  std::transform(low.column(0), low.column(1), weight.column(0), std::negate());
  std::copy(high.column(0), high.column(1), weight.column(0) + side[0].count);
  return squares(weight) * noise.widening(weight) + side[0].misfit + side[1].misfit;
}

StepSides step_sides(Matrix series, const std::vector<double>& time, double step, const StepGap& gap,
                     const StepOptions& options, const std::vector<double>& jumps) {
  const std::array<Place, 2> places = places_of(time, step, gap, options, jumps);
  weigh(series, places);
  StepSides sides;
  for (std::size_t k = 0; k < 2; ++k) {
    const bool room = places[k].count() >= static_cast<std::size_t>(options.drift_order) + 12;
    sides.side[k] = side_of(places[k], room && series.rows() > 0 ? best_relaxation(series, places[k]) : 0);
  }
  if (series.rows() == 0) return sides;
  double variance = measure_noise(series, sides);
  for (std::size_t k = 0; k < 2; ++k)
    if (sides.side[k].relaxation > 0 && variance > 0)
      sides.side[k] = choose(series, places[k], sides.side[k], sides.noise, variance);
  variance = measure_noise(series, sides);
  sides.evidence = std::numeric_limits<double>::infinity();
  if (variance > 0) {
    const Matrix high = heights(series, sides.side[1]);
    Matrix jump = high, onward = heights(series, side_of(places[1], 0));
    jump -= heights(series, sides.side[0]), onward -= high;
    sides.evidence = squares(jump) / static_cast<double>(series.rows()) / variance / sides.variance();
    if (sides.side[1].relaxation > 0)
      sides.side[1].onward = statistics::dot(jump.column(0), onward.column(0), jump.size()) / squares(jump);
  }
  return sides;
}

}  // namespace arenite::thermography
