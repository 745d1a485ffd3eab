#pragma once
#include <algorithm>
#include <cstddef>
#include <functional>
#include <iterator>
#include <numeric>
#include <type_traits>
#include <vector>

namespace arenite {

/// `of` of every item of a range, in its order: a function, or a member of the items. With a type given, the results
/// are turned into it.
template <class As = void, class Range, class Of> auto mapped(const Range& range, Of of) {
  using Result = std::decay_t<decltype(std::invoke(of, *std::begin(range)))>;
  std::vector<std::conditional_t<std::is_void_v<As>, Result, As>> results;
  results.reserve(std::size(range));
  for (const auto& item : range) results.emplace_back(std::invoke(of, item));
  return results;
}

/// 0 .. n-1 by rising `key` of each; of equal ones the first comes first.
template <class Key> std::vector<std::size_t> ordered_by(std::size_t n, const Key& key) {
  std::vector<std::size_t> order(n);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::ranges::stable_sort(order, {}, key);
  return order;
}

}  // namespace arenite
