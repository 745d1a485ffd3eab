#pragma once
#include <cstddef>

#include "statistics/estimate.hpp"

namespace arenite::statistics {

/// What a difference of two numbers says. `unjudged`: they differ, and neither has an error; `alone`: one is not known.
enum class Verdict { beyond, within, equal, unjudged, alone };

/// Two numbers are told to differ from here on, in standard errors of their difference.
inline constexpr double least_told = 2;

struct Difference {
  double value = unknown;
  double error = unknown;      ///< of numbers of samples that know nothing of each other; of the one that has an error
  double in_errors = unknown;  ///< value over error; not known without an error
  Verdict verdict = Verdict::alone;
};

/// b - a. Of angles with a period, in their unit, the shorter way; 0: what is no angle.
Difference difference_of(const Estimate& a, const Estimate& b, double period = 0);

/// `over` / a.
Estimate inverse_of(const Estimate& a, double over = 1);

/// How many of so many differences of equal samples chance alone puts beyond `least_told`, by the normal law.
double beyond_by_chance(std::size_t judged);

}  // namespace arenite::statistics
