#pragma once
#include <functional>

namespace arenite {

/// Where f changes sign between a and b, whose values fa and fb have different signs (or one is 0): a jump is found as
/// surely as a root (Alefeld, Potra, Shi: algorithm 748, by Boost.Math). The bracket is closed to the last bits of its
/// ends; the end with the smaller |f| is returned. For Real double and long double.
template <class Real> Real bracketed_root(const std::function<Real(Real)>& f, Real a, Real fa, Real b, Real fb);

/// Where f, which has one minimum between a and b, is least, to half of its digits (Brent, by Boost.Math).
double minimum_between(const std::function<double(double)>& f, double a, double b);

}  // namespace arenite
