#pragma once
#include <cmath>

namespace arenite::dem::lane {

/// The few functions that a law calls beside + - * /. Laws are written once over a number type V; these serve
/// V = double, a batch type brings its own overloads (found by its namespace).
inline double min(double a, double b) { return b < a ? b : a; }
inline double max(double a, double b) { return a < b ? b : a; }
inline double sqrt(double a) { return std::sqrt(a); }
inline double select(bool condition, double yes, double no) { return condition ? yes : no; }

/// a held within [-bound, bound], bound >= 0.
template <class V>
V within(V a, V bound) {
  return max(min(a, bound), V(0.0) - bound);
}

}  // namespace arenite::dem::lane
