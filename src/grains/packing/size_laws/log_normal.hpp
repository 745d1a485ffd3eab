#pragma once
#include <cmath>
#include <cstdint>

#include "grains/packing/size_laws/uniform.hpp"

namespace arenite::packing {

/// Logarithms of diameters are Gaussian; drawn again until it lies between min and max.
struct LogNormalSizes : UniformSizes {
  double median = 0, spread = 0;  ///< before the truncation: m, and the standard deviation of ln d

  static constexpr Word word{"log_normal", "log-normal distribution, truncated to min..max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"median", "Median diameter before truncation.", true}, median, "mm", range::positive);
    visitor.number({"spread", "Standard deviation of the natural logarithm of the diameter.", true}, spread, "",
                   range::between(0, 5));
    UniformSizes::declare(visitor);
    visitor.require(median >= min && median <= max, {"median", "min", "max"}, "must lie between min and max");
  }
  bool operator==(const LogNormalSizes&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& random) const {
    return truncated(*this, "log-normal", "median", [&] { return median * std::exp(spread * random.normal()); });
  }
};

}  // namespace arenite::packing
