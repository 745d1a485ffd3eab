#pragma once
#include <cstdint>
#include <vector>

#include "model/result.hpp"
#include "report/number_block.hpp"
#include "statistics/numbers.hpp"

/// Pieces that packings and fields write alike into the page's document.
namespace arenite::report {


inline Numbers reference(const NumberRef& ref) { return {{"at", ref.offset}, {"n", ref.count}, {"as", ref.type}}; }

template <class T>
std::vector<std::uint32_t> unsigned_copy(const std::vector<T>& values) {
  std::vector<std::uint32_t> copy(values.size());
  for (std::size_t k = 0; k < values.size(); ++k) copy[k] = static_cast<std::uint32_t>(values[k]);
  return copy;
}

/// Every column with its unit, at most about a thousand rows of it.
Numbers history_of(const History& history, NumberBlock& block);
Numbers provenance_of(const Provenance& provenance);

/// Six significant digits: more than a figure or a standard error can use, and a third of the bytes.
void shorten(Numbers& value);

}  // namespace arenite::report
