#pragma once
#include <algorithm>
#include <cstdint>
#include <vector>

#include "core/parameters.hpp"
#include "core/random.hpp"

namespace arenite::packing {

struct SizeList {
  std::vector<double> values;  ///< diameters, m

  static constexpr Word word{"list", "the values in turn, repeated cyclically"};
  void declare(ParameterVisitor& visitor) {
    visitor.numbers({"values", "The diameters.", true}, values, "mm", range::positive);
    visitor.require(!values.empty(), {"values"}, "must hold at least one diameter");
  }
  bool operator==(const SizeList&) const = default;

  double draw(std::int64_t k, RandomStream& /*random*/) const {
    return values[static_cast<std::size_t>(k) % values.size()];
  }
  double largest() const { return values.empty() ? 0 : *std::max_element(values.begin(), values.end()); }
  double smallest() const { return values.empty() ? 0 : *std::min_element(values.begin(), values.end()); }
};

}  // namespace arenite::packing
