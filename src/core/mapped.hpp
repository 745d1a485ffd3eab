#pragma once
#include <functional>
#include <iterator>
#include <type_traits>
#include <vector>

namespace arenite {

/// `of` of every item of a range, in its order: a function, or a member of the items. With a type given, the results are turned into it.
template <class As = void, class Range, class Of> auto mapped(const Range& range, Of of) {
  using Result = std::decay_t<decltype(std::invoke(of, *std::begin(range)))>;
  std::vector<std::conditional_t<std::is_void_v<As>, Result, As>> results;
  results.reserve(std::size(range));
  for (const auto& item : range) results.emplace_back(std::invoke(of, item));
  return results;
}

}  // namespace arenite
