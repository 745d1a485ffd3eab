#pragma once
#include <algorithm>
#include <cstddef>
#include <vector>

/// Values by their rank among others.
namespace arenite {

/// The value of a rank by size, 0 of the least, of more values than that; they are left in another order.
template <class T> T of_rank_in_place(std::vector<T>& values, std::size_t rank) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// The same of values that stay as they are.
template <class T> T of_rank(std::vector<T> values, std::size_t rank) { return of_rank_in_place(values, rank); }

/// Of n values, one or more, that of rank share (n - 1), rounded down: the least at 0, the largest at 1.
template <class T> T at_share(std::vector<T> values, double share) {
  return of_rank_in_place(values, static_cast<std::size_t>(share * static_cast<double>(values.size() - 1)));
}

}  // namespace arenite
