#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "grains/packing/size_laws/uniform.hpp"

namespace arenite::packing {

/// Number density ~ d^-exponent between min and max (fragments, fractal gradings), by the inverse of its distribution.
struct PowerLawSizes : UniformSizes {
  double exponent = 2;

  static constexpr Word word{"power_law", "number of grains as diameter^-exponent, between min and max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number(
        {"exponent", "Of the number density; 1 + D for a fractal dimension D of the numbers above a size.", true},
        exponent, "", range::between(-10, 10));
    UniformSizes::declare(visitor);
  }
  bool operator==(const PowerLawSizes&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& random) const {
    const double u = random.uniform(0, 1), p = 1 - exponent;
    if (std::abs(p) < 1e-9) return min * std::pow(max / min, u);
    return std::min(max, min * std::pow(1 + u * std::expm1(p * std::log(max / min)), 1 / p));
  }
};

}  // namespace arenite::packing
