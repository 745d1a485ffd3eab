#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "grains/packing/size_laws/uniform.hpp"

namespace arenite::packing {

/// P(D > d) = exp(-(d/scale)^shape) by number (Rosin-Rammler), truncated to min..max by the inverse of its
/// distribution.
struct WeibullSizes : UniformSizes {
  double scale = 0, shape = 1;  ///< m, 1

  static constexpr Word word{"weibull", "Weibull (Rosin-Rammler) by number, truncated to min..max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"scale", "Diameter exceeded by 1/e of the grains, before truncation.", true}, scale, "mm",
                   range::positive);
    visitor.number({"shape", "Exponent: larger is narrower.", true}, shape, "", range::between(0.1, 100));
    UniformSizes::declare(visitor);
  }
  bool operator==(const WeibullSizes&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& random) const {
    const auto above = [this](double d) { return std::exp(-std::pow(d / scale, shape)); };
    const double share = above(min) - random.uniform(0, 1) * (above(min) - above(max));
    return share > 0 ? std::clamp(scale * std::pow(-std::log(share), 1 / shape), min, max) : max;
  }
};

}  // namespace arenite::packing
