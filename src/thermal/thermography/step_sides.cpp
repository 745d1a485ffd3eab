#include "thermal/thermography/step_sides.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.hpp"

namespace arenite::thermography {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Pixels that vary independently, from the mean square correlation of pairs less what chance gives it (Bartlett).
double independent_pixels(const MatrixXd& residual, const std::vector<double>& lag) {
  const Index all = residual.rows(), every = std::max<Index>(1, all / 128), count = (all + every - 1) / every;
  if (count < 2) return 1;
  MatrixXd some(count, residual.cols());
  for (Index i = 0; i < count; ++i) some.row(i) = residual.row(i * every).normalized();
  const MatrixXd pairs = some * some.transpose();
  const auto n = static_cast<double>(count);
  double chance = 1;
  for (const double r : lag) chance += 2 * r * r;
  const double square = (pairs.squaredNorm() - n) / (n * (n - 1)) - chance / static_cast<double>(residual.cols());
  return static_cast<double>(all) / (1 + (static_cast<double>(all) - 1) * std::max(square, 0.0));
}

/// Sums over frames and rows of products of values so many frames apart.
std::vector<double> products(const MatrixXd& value, Index lags) {
  std::vector<double> sums;
  for (Index k = 1; k <= lags; ++k) sums.push_back(value.leftCols(value.cols() - k).cwiseProduct(value.rightCols(value.cols() - k)).sum());
  return sums;
}

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of pixels x frames, left by a fit of the functions `fitted` (functions x frames, orthonormal), which takes some correlation with it.
ResidualCorrelation residual_correlation(const MatrixXd& residual, const MatrixXd& fitted) {
  ResidualCorrelation result;
  const auto frames = static_cast<double>(residual.cols()), functions = static_cast<double>(fitted.rows());
  const double squares = residual.squaredNorm();
  if (residual.size() == 0 || !(squares > 0)) return result;
  const Index lags = residual.cols() / 4;
  const std::vector<double> seen = products(residual, lags), taken = products(fitted, lags);
  const double lost_in_noise = std::max(1e-3, 2 / std::sqrt(frames * independent_pixels(residual, {})));
  double sum = 1;
  // In white noise the fit takes just this from each lag; of correlated noise, strongest where the fit is, as much more (Marriott and Pope 1954).
  for (int turn = 0; turn < 8; ++turn) {
    result.lag.clear();
    double next = 1;
    for (std::size_t k = 0; k < seen.size(); ++k) {
      const double r = seen[k] / squares + sum * taken[k] / (frames - functions);
      if (r < lost_in_noise) break;
      result.lag.push_back(std::min(r, 0.999));
      next += 2 * result.lag.back();
    }
    sum = std::min(next, frames / (4 * functions + 4));
  }
  result.pixels = independent_pixels(residual, result.lag);
  return result;
}

/// Where a side lies: its frames, and the end that is not at the step.
struct Place {
  const std::vector<double>& time;
  std::size_t first, end;
  double step;
  int order;

  std::size_t count() const { return end - first; }
  double length() const { return std::max(std::abs(time[first] - step), std::abs(time[end - 1] - step)); }
  /// An exponential falls from where the side begins.
  double since(double t) const { return t - std::min(step, time[first]); }
};

/// `with_time` adds the function by which the fit changes when the relaxation's time does.
StepSide side_of(const Place& at, double relaxation, bool with_time = false) {
  const Index powers = at.order + 1, size = powers + (relaxation > 0 ? 1 : 0) + (with_time ? 1 : 0);
  StepSide side{at.first, at.count(), relaxation, {}, VectorXd::Zero(size), VectorXd::Zero(size), 0};
  const double length = at.length();
  VectorXd value(size), slope(size);
  const auto functions = [&](double t) {
    const double x = (t - at.step) / length;
    for (Index k = 0; k < powers; ++k) {
      value[k] = k == 0 ? 1 : value[k - 1] * x;
      slope[k] = k == 0 ? 0 : static_cast<double>(k) * value[k - 1] / length;
    }
    if (relaxation <= 0) return;
    const double since = at.since(t), fall = std::exp(-since / relaxation);
    value[powers] = fall, slope[powers] = -fall / relaxation;
    if (with_time) value[powers + 1] = since / length * fall, slope[powers + 1] = (1 - since / relaxation) / length * fall;
  };
  MatrixXd all(static_cast<Index>(side.count), size);
  for (Index n = 0; n < all.rows(); ++n) {
    functions(at.time[at.first + static_cast<std::size_t>(n)]);
    all.row(n) = value;
  }
  const Eigen::HouseholderQR<MatrixXd> qr(all);
  side.weight = (qr.householderQ() * MatrixXd::Identity(all.rows(), size)).transpose();
  const MatrixXd r = qr.matrixQR().topRows(size).triangularView<Eigen::Upper>();
  functions(at.step);
  side.height = r.transpose().triangularView<Eigen::Lower>().solve(value);
  side.slope = r.transpose().triangularView<Eigen::Lower>().solve(slope);
  return side;
}

MatrixXd frames_of(const MatrixXd& series, const StepSide& side) { return series.middleCols(static_cast<Index>(side.first), static_cast<Index>(side.count)); }

MatrixXd left_by(const MatrixXd& series, const StepSide& side) {
  const MatrixXd value = frames_of(series, side);
  return value - (value * side.weight.transpose()) * side.weight;
}

/// The time in which all pixels together relax best: on a ladder of times, then between its rungs.
double best_relaxation(const MatrixXd& series, const Place& at) {
  constexpr double rung = 1.25;
  const double shortest = 3 * at.length() / static_cast<double>(at.count());
  const StepSide plain = side_of(at, 0);
  const MatrixXd rest = left_by(series, plain);
  const auto explained = [&](double log_time) {
    const StepSide side = side_of(at, std::exp(log_time));
    return (rest * side.weight.bottomRows(1).transpose()).squaredNorm();
  };
  double best = std::log(shortest), most = -1;
  for (double t = std::log(shortest); t <= std::log(at.length()); t += std::log(rung))
    if (const double e = explained(t); e > most) most = e, best = t;
  double low = best - std::log(rung), high = best + std::log(rung);
  for (int turn = 0; turn < 20; ++turn) {
    const double a = low + 0.382 * (high - low), b = low + 0.618 * (high - low);
    if (explained(a) > explained(b)) high = b;
    else low = a;
  }
  return std::exp((low + high) / 2);
}

MatrixXd joined(const MatrixXd& a, const MatrixXd& b) {
  MatrixXd all(a.rows(), a.cols() + b.cols());
  all << a, b;
  return all;
}

/// The side with or without the exponential; what is left of one that is not sure is an error.
StepSide choose(const MatrixXd& series, const Place& at, const StepSide& relaxing, const ResidualCorrelation& noise, double variance) {
  const StepSide plain = side_of(at, 0);
  const VectorXd more = relaxing.weight.bottomRows(1).transpose();
  const double widening = noise.widening(more), explained = (frames_of(series, plain) * more).squaredNorm() / static_cast<double>(series.rows()) / variance / widening;
  const double wider = relaxing.height_weights().squaredNorm() - plain.height_weights().squaredNorm();
  if (explained > chi_squared_above(noise.pixels, 4)) {
    StepSide side = relaxing;
    side.misfit = std::max(0.0, side_of(at, relaxing.relaxation, true).height_weights().squaredNorm() - relaxing.height_weights().squaredNorm()) / noise.pixels;
    return side;
  }
  StepSide side = plain;
  side.misfit = std::max(0.0, wider) * widening * std::max(0.0, explained - std::min(2.0, chi_squared_above(noise.pixels, 3)));
  return side;
}

/// Divides every pixel by what the polynomials leave of it; one of which they leave nothing says nothing of the noise.
void weigh(MatrixXd& series, const StepSide& before, const StepSide& after) {
  const VectorXd left = (left_by(series, before).rowwise().squaredNorm() + left_by(series, after).rowwise().squaredNorm()) / static_cast<double>(before.count + after.count);
  for (Index i = 0; i < series.rows(); ++i) series.row(i) *= left[i] > 0 ? 1 / std::sqrt(left[i]) : 0;
}

double freedom(const StepSide& side) { return static_cast<double>(side.count) - static_cast<double>(side.height.size()); }

}  // namespace

double ResidualCorrelation::widening(const Eigen::VectorXd& weight) const {
  double sum = weight.squaredNorm();
  for (std::size_t k = 1; k <= lag.size() && static_cast<Index>(k) < weight.size(); ++k) {
    const auto far = static_cast<Index>(k);
    sum += 2 * lag[k - 1] * weight.head(weight.size() - far).dot(weight.tail(weight.size() - far));
  }
  return std::max(sum / weight.squaredNorm(), 1.0);
}

double chi_squared_above(double numbers, double deviations) {
  const double variance = 2 / (9 * numbers);
  return std::pow(1 - variance + deviations * std::sqrt(variance), 3);
}

double StepSides::variance() const {
  VectorXd weight(static_cast<Index>(before.count + after.count));
  weight << -before.height_weights(), after.height_weights();
  return weight.squaredNorm() * noise.widening(weight) + before.misfit + after.misfit;
}

StepSides step_sides(MatrixXd series, const std::vector<double>& time, double step, int order, std::size_t first, std::size_t end,
                     std::size_t begin, std::size_t last) {
  const auto check = [&](std::size_t from, std::size_t to, const char* name) {
    if (to >= from + static_cast<std::size_t>(order) + 3) return;
    throw InputError(fmt::format("the film has {} frames {} the step at {:.6g} s that can be used, too few for a drift of order {}; give another time, a longer "
                                 "window, a shorter rise or less drift", to > from ? to - from : 0, name, step, order));
  };
  check(first, end, "before");
  check(begin, last, "after");
  const Place places[2] = {{time, first, end, step, order}, {time, begin, last, step, order}};
  weigh(series, side_of(places[0], 0), side_of(places[1], 0));
  StepSide side[2];
  for (int k = 0; k < 2; ++k) {
    const bool room = places[k].count() >= static_cast<std::size_t>(order) + 12;
    side[k] = side_of(places[k], room && series.rows() > 0 ? best_relaxation(series, places[k]) : 0);
  }
  if (series.rows() == 0) return {side[0], side[1], {}, 0};
  const auto noise_of = [&](double& variance) {
    const MatrixXd left = joined(left_by(series, side[0]), left_by(series, side[1]));
    variance = left.squaredNorm() / static_cast<double>(left.rows()) / (freedom(side[0]) + freedom(side[1]));
    MatrixXd fitted = MatrixXd::Zero(side[0].height.size() + side[1].height.size(), left.cols());
    fitted.topLeftCorner(side[0].height.size(), side[0].weight.cols()) = side[0].weight;
    fitted.bottomRightCorner(side[1].height.size(), side[1].weight.cols()) = side[1].weight;
    return residual_correlation(left, fitted);
  };
  double variance = 0;
  const ResidualCorrelation noise = noise_of(variance);
  for (int k = 0; k < 2; ++k)
    if (side[k].relaxation > 0 && variance > 0) side[k] = choose(series, places[k], side[k], noise, variance);
  StepSides sides{side[0], side[1], noise_of(variance), std::numeric_limits<double>::infinity()};
  if (variance > 0)
    sides.evidence = (frames_of(series, side[1]) * side[1].height_weights() - frames_of(series, side[0]) * side[0].height_weights()).squaredNorm() /
                     static_cast<double>(series.rows()) / variance / sides.variance();
  return sides;
}

}  // namespace arenite::thermography
