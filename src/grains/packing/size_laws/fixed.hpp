#pragma once
#include <cstdint>

#include "core/parameters.hpp"
#include "core/random.hpp"

namespace arenite::packing {

struct FixedSize {
  double diameter = 0;  ///< m

  static constexpr Word word{"fixed", "one diameter"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"diameter", "The diameter.", true}, diameter, "mm", range::positive);
  }
  bool operator==(const FixedSize&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& /*random*/) const { return diameter; }
  double largest() const { return diameter; }
  double smallest() const { return diameter; }
};

}  // namespace arenite::packing
