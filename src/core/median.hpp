#pragma once
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace arenite {

/// The middle of the values by size, of two middle ones the larger; `none` where there is no value.
template <class T>
double median(std::vector<T> values, double none = 0) {
  if (values.empty()) return none;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return static_cast<double>(*middle);
}

/// Of the values that are finite; NaN where none is.
template <class T>
double median_of_finite(std::vector<T> values) {
  std::erase_if(values, [](T v) { return !std::isfinite(v); });
  return median(std::move(values), std::numeric_limits<double>::quiet_NaN());
}

}  // namespace arenite
