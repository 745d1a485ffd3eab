#include "core/root.hpp"

#include <algorithm>
#include <boost/math/tools/minima.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

namespace arenite {

template <class Real> Real bracketed_root(const std::function<Real(Real)>& f, Real a, Real fa, Real b, Real fb) {
  if (fa != 0 && fb != 0 && (fa < 0) != (fb < 0)) {
    const Real left = a, right = b, f_left = fa, f_right = fb;  // where the bracket starts; a and b close with it
    const auto value = [&](Real x) {
      const Real y = f(x);
      const bool like_a = (y < 0) == (fa < 0);
      (like_a ? a : b) = x;
      return (like_a ? fa : fb) = y;
    };
    const auto closed = [](Real low, Real high) {
      return high - low <= 2 * std::numeric_limits<Real>::epsilon() * std::min(std::abs(low), std::abs(high));
    };
    std::uintmax_t most = 200;
    boost::math::tools::toms748_solve(value, left, right, f_left, f_right, closed, most);
  }
  return std::abs(fa) < std::abs(fb) ? a : b;
}

double minimum_between(const std::function<double(double)>& f, double a, double b) {
  return boost::math::tools::brent_find_minima(f, a, b, std::numeric_limits<double>::digits / 2).first;
}

template double bracketed_root(const std::function<double(double)>&, double, double, double, double);
template long double bracketed_root(const std::function<long double(long double)>&, long double, long double,
                                    long double, long double);

}  // namespace arenite
