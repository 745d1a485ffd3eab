#pragma once
#include <string>
#include <utility>
#include <vector>

#include "statistics/measured.hpp"

namespace arenite::validation {

/// A number with its standard error and the degrees of freedom behind that: seeds or samples less one. Infinite: the
/// error is known for certain; error 0: so is the number.
using Value = statistics::Measured;

/// Sum of weights times independent values; degrees of freedom after Welch and Satterthwaite. One error that is not
/// known makes the sum's unknown.
Value weighted_sum(const std::vector<std::pair<double, Value>>& terms);
Value difference(const Value& a, const Value& b);
Value ratio(const Value& a, const Value& b);
/// |v| with the error of v.
Value size_of(const Value& v);

/// Of the 95 % interval, beyond either end.
inline constexpr double usual_side = 0.025;
/// Half the interval that covers the true value in 95 of 100 cases, by Student's t, or leaves `side` beyond either end;
/// NaN where the error is not known.
double half_interval(const Value& v, double side = usual_side);
/// How often a true value at `bound` would give one as far above it; NaN where the error is not known.
double chance_above(const Value& v, double bound);

/// How often zero would give a value as far from it, to either side; 1 for what is zero within rounding.
double chance_of_zero(const Value& v);

/// "0.403 +- 0.012": two digits of the error, and of the value what goes with them.
std::string text_of(const Value& v);

}  // namespace arenite::validation
