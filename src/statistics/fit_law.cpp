#include "statistics/fit_law.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "statistics/correlation.hpp"
#include "statistics/least_squares.hpp"

namespace arenite::statistics {
namespace {

constexpr int most_rounds = 200;
constexpr double step = 1e-6;  // of a parameter, for slopes: its square is far below the errors of any fit

void check(std::size_t parameters, const std::vector<double>& x, const std::vector<double>& y,
           const std::vector<double>& error) {
  if (x.size() != y.size() || y.size() != error.size())
    throw refusal("there are {} places, {} values and {} errors; give one of each a point", x.size(), y.size(),
                  error.size());
  for (std::size_t k = 0; k < x.size(); ++k)
    if (!std::isfinite(x[k]) || !std::isfinite(y[k])) throw refusal("point {} of the fit is not finite", k);
    else if (error[k] < 0) throw refusal("the error of point {} of the fit is {}; it must not be below 0", k, error[k]);
  if (x.size() < parameters)
    throw refusal("{} points do not determine {} parameters; give at least {}", x.size(), parameters, parameters);
}

bool is_known(double error) { return std::isfinite(error) && error > 0; }

/// What a point's residual is counted in.
std::vector<double> scales(const std::vector<double>& y, const std::vector<double>& error) {
  double largest = 0;
  for (const double e : error)
    if (is_known(e)) largest = std::max(largest, e);
  if (largest > 0) return mapped(error, [&](double e) { return is_known(e) ? e : largest; });
  const SecondMoments moments = second_moments(y, y);
  const double spread = std::sqrt(moments.yy / static_cast<double>(y.size()));
  return std::vector<double>(y.size(), spread > 0 ? spread : 1.0);
}

class Fit {
 public:
  Fit(const Law& law, std::vector<double> start, const std::vector<double>& x, const std::vector<double>& y,
      const std::vector<double>& error)
      : law_(law),
        x_(x),
        y_(y),
        scale_(scales(y, error)),
        at_(std::move(start)),
        errors_known_(std::ranges::any_of(error, is_known)) {}

  std::vector<Estimate> solution() {
    Matrix residual = residuals(at_);
    double damping = 1e-3;
    for (int round = 0; round < most_rounds && damping < 1e12; ++round) {
      const std::vector<double> trial = moved(residual, damping);
      const Matrix after = residuals(trial);
      const double then = squares(after), now = squares(residual);
      const bool better = std::isfinite(then) && then <= now;
      damping = better ? damping / 5 : damping * 5;
      if (!better) continue;
      at_ = trial;
      residual = after;
      if (now - then < 1e-12 * then || then == 0) break;
    }
    return with_errors(squares(residual));
  }

 private:
  Matrix residuals(const std::vector<double>& parameters) const {
    Matrix r(x_.size(), 1);
    for (std::size_t k = 0; k < x_.size(); ++k) r(k, 0) = (y_[k] - law_(x_[k], parameters)) / scale_[k];
    return r;
  }

  Matrix slopes() const {
    Matrix slope(x_.size(), at_.size());
    for (std::size_t p = 0; p < at_.size(); ++p) {
      const double h = step * std::max(std::abs(at_[p]), 1e-9);
      auto low = at_, high = at_;
      low[p] -= h, high[p] += h;
      for (std::size_t k = 0; k < x_.size(); ++k)
        slope(k, p) = (law_(x_[k], high) - law_(x_[k], low)) / (2 * h * scale_[k]);
    }
    return slope;
  }

  /// The next parameters, by normal equations whose diagonal is enlarged.
  std::vector<double> moved(const Matrix& residual, double damping) const {
    const Matrix slope = slopes();
    Matrix normal = transposed_times(slope, slope);
    for (std::size_t p = 0; p < at_.size(); ++p) normal(p, p) *= 1 + damping;
    const Matrix step_taken = solve_symmetric(normal, transposed_times(slope, residual));
    auto next = at_;
    for (std::size_t p = 0; p < next.size(); ++p) next[p] += step_taken(p, 0);
    return next;
  }

  std::vector<Estimate> with_errors(double sum) const {
    const Matrix slope = slopes();
    const Matrix covariance = solve_symmetric(transposed_times(slope, slope), identity(at_.size(), at_.size()));
    const double freedom = std::max(1.0, static_cast<double>(x_.size()) - static_cast<double>(at_.size()));
    const double spread = errors_known_ ? std::max(1.0, sum / freedom) : sum / freedom;
    std::vector<Estimate> found;
    for (std::size_t p = 0; p < at_.size(); ++p) found.push_back({at_[p], std::sqrt(covariance(p, p) * spread)});
    return found;
  }

  const Law& law_;
  const std::vector<double>&x_, &y_;
  const std::vector<double> scale_;
  std::vector<double> at_;
  const bool errors_known_;
};

}  // namespace

std::vector<Estimate> fit_law(const Law& law, std::vector<double> start, const std::vector<double>& x,
                              const std::vector<double>& y, const std::vector<double>& error) {
  check(start.size(), x, y, error);
  return Fit(law, std::move(start), x, y, error).solution();
}

PowerLaw fit_power(const std::vector<double>& x, const std::vector<double>& y, const std::vector<double>& error) {
  check(2, x, y, error);
  if (std::ranges::any_of(x, [](double v) { return !(v > 0); }) ||
      std::ranges::any_of(y, [](double v) { return !(v > 0); }))
    throw InputError("a power law is fitted to values above 0; leave out the others");
  const auto logarithms = [](const std::vector<double>& v) { return mapped(v, [](double a) { return std::log(a); }); };
  const SecondMoments m = second_moments(logarithms(x), logarithms(y));
  if (!(m.xx > 0)) throw InputError("a power law is fitted to points at two places at least; these are at one");
  const double exponent = m.xy / m.xx, factor = std::exp(m.mean_y - exponent * m.mean_x);
  const auto law = [](double at, const std::vector<double>& p) { return p[0] * std::pow(at, p[1]); };
  const auto found = fit_law(law, {factor, exponent}, x, y, error);
  return {found[0], found[1]};
}

}  // namespace arenite::statistics
