#pragma once
#include <cstdint>

#include "grains/packing/size_laws/uniform.hpp"

namespace arenite::packing {

/// Drawn again until it lies between min and max.
struct NormalSizes : UniformSizes {
  double mean = 0, deviation = 0;  ///< before the cut, m

  static constexpr Word word{"normal", "normal distribution of given mean and deviation, truncated to min..max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"mean", "Mean diameter before truncation.", true}, mean, "mm", range::positive);
    visitor.number({"deviation", "Standard deviation before truncation.", true}, deviation, "mm", range::not_negative);
    UniformSizes::declare(visitor);
    visitor.require(mean >= min && mean <= max, {"mean", "min", "max"}, "must lie between min and max");
  }
  bool operator==(const NormalSizes&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& random) const {
    return truncated(*this, "normal", "mean", [&] { return mean + deviation * random.normal(); });
  }
};

}  // namespace arenite::packing
