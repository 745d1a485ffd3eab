#pragma once
#include <cstdint>

#include "core/parameters.hpp"
#include "core/random.hpp"

namespace arenite::packing {

struct UniformSizes {
  double min = 0, max = 0;  ///< m

  static constexpr Word word{"uniform", "uniformly between min and max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"min", "Smallest diameter.", true}, min, "mm", range::positive);
    visitor.number({"max", "Largest diameter.", true}, max, "mm", range::positive);
    visitor.require(max >= min, {"max", "min"}, "must not be below min");
  }
  bool operator==(const UniformSizes&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& random) const { return random.uniform(min, max); }
  double largest() const { return max; }
  double smallest() const { return min; }
};

/// Throws InputError: the truncation of a law leaves almost none of its grains. Lengths in m.
[[noreturn]] void refuse_truncation(const UniformSizes& law, const char* name, const char* centre);

/// Draws until a diameter lies between min and max. Throws InputError where these lie far out in the tail; a recipe
/// keeps the law's centre between them.
template <class Draw> double truncated(const UniformSizes& law, const char* name, const char* centre, Draw&& draw) {
  for (int attempt = 0; attempt < 100'000; ++attempt)
    if (const double d = draw(); d >= law.min && d <= law.max) return d;
  refuse_truncation(law, name, centre);
}

}  // namespace arenite::packing
