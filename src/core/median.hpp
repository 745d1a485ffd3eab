#pragma once
#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace arenite {

/// The middle of one value or more by size, of two middle ones the larger; the values are left in another order.
template <class Iterator> double median_in_place(Iterator begin, Iterator end) {
  const auto middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end);
  return static_cast<double>(*middle);
}

/// The same; `none` where there is no value.
template <class T> double median(std::vector<T> values, double none = 0) {
  return values.empty() ? none : median_in_place(values.begin(), values.end());
}

/// Of the values that are finite; NaN where none is.
template <class T> double median_of_finite(std::vector<T> values) {
  std::erase_if(values, [](T v) { return !std::isfinite(v); });
  return median(std::move(values), std::numeric_limits<double>::quiet_NaN());
}

/// Of values (first) by their weights (second); `none` where there is no value.
inline double weighted_median(std::vector<std::pair<double, double>> weighed, double none = 0) {
  std::sort(weighed.begin(), weighed.end());
  double all = 0, sum = 0;
  for (const auto& v : weighed) all += v.second;
  for (const auto& v : weighed)
    if ((sum += v.second) >= all / 2) return v.first;
  return none;
}

/// Medians over the standard deviation: of the size of a normal variable, and of the distance in the plane of a place
/// whose coordinates are normal.
inline constexpr double median_of_normal_size = 0.6744897501960817, median_of_plane_distance = 1.1774100225154747;

}  // namespace arenite
