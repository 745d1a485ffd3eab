#pragma once
#include <cmath>

namespace arenite {

/// Where f changes sign between a and b, whose values have different signs: inverse quadratic interpolation where that is
/// safe, bisection elsewhere (Chandrupatla 1997), so a jump is found as surely as a root. Stops when |f| <= f_tolerance
/// or the bracket is narrower than x_tolerance; returns the end with the smaller |f|.
template <class F>
double bracketed_root(F&& f, double a, double fa, double b, double fb, double x_tolerance, double f_tolerance) {
  double x1 = b, f1 = fb, x2 = a, f2 = fa, x3 = a, f3 = fa, t = 0.5;
  for (int k = 0; k < 200; ++k) {
    const double best = std::abs(f1) < std::abs(f2) ? x1 : x2;
    if (std::abs(f1) <= f_tolerance || std::abs(f2) <= f_tolerance || std::abs(x1 - x2) <= x_tolerance) return best;
    const double x = x1 + t * (x2 - x1);
    if (x == x1 || x == x2) return best;
    const double fx = f(x);
    if ((fx < 0) == (f1 < 0)) {
      x3 = x1, f3 = f1;
    } else {
      x3 = x2, f3 = f2;
      x2 = x1, f2 = f1;
    }
    x1 = x, f1 = fx;
    const double xi = (x1 - x2) / (x3 - x2), phi = (f1 - f2) / (f3 - f2);
    t = 0.5;
    if (phi * phi < xi && (1 - phi) * (1 - phi) < 1 - xi)
      t = f1 / (f2 - f1) * f3 / (f2 - f3) + (x3 - x1) / (x2 - x1) * f1 / (f3 - f1) * f2 / (f3 - f2);
    const double least = 0.5 * x_tolerance / std::abs(x1 - x2);
    t = t < least ? least : t > 1 - least ? 1 - least : t;
  }
  return std::abs(f1) < std::abs(f2) ? x1 : x2;
}

}  // namespace arenite
