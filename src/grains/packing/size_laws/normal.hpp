#pragma once
#include "grains/packing/size_laws/uniform.hpp"

namespace arenite::packing {

/// Drawn again until it lies between min and max.
struct NormalSizes : UniformSizes {
  double mean = 0, deviation = 0;  ///< before the cut, m

  static constexpr Word word{"normal", "Gaussian of mean and deviation, cut to min..max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"mean", "Mean diameter before the cut.", true}, mean, "mm", range::positive);
    visitor.number({"deviation", "Standard deviation before the cut.", true}, deviation, "mm", range::not_negative);
    UniformSizes::declare(visitor);
    visitor.require(mean >= min && mean <= max, {"mean", "min", "max"}, "must lie between min and max");
  }
  bool operator==(const NormalSizes&) const = default;

  /// Throws InputError where the cut lies far out in the tail; a recipe keeps it around the mean.
  double draw(std::int64_t /*k*/, RandomStream& random) const {
    for (int attempt = 0; attempt < 100'000; ++attempt)
      if (const double d = mean + deviation * random.normal(); d >= min && d <= max) return d;
    refuse_truncation(*this, "normal", "mean");
  }
};

}  // namespace arenite::packing
