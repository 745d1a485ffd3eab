#pragma once
#include <algorithm>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/parameters.hpp"
#include "core/random.hpp"

namespace arenite::packing {

/// A grading curve by mass: between two sieves mass is spread evenly over diameters. Cylinders of one length weigh as
/// d^2, so the number of grains of a class is its mass times the mean of 1/d^2, and 1/d of its grains is spread evenly.
struct SieveCurve {
  std::vector<double> sieves, passing;  ///< m, rising; share of the mass below each, 0 to 1

  static constexpr Word word{"sieve_curve", "a grading curve by mass: sieve sizes and the fraction passing each"};
  void declare(ParameterVisitor& visitor) {
    visitor.numbers({"sieves", "Sizes of the sieves, increasing.", true}, sieves, "mm", range::positive);
    visitor.numbers({"passing", "Fraction of the mass that passes each, from 0 at the first to 1 at the last.", true},
                    passing, "%", range::between(0, 1));
    visitor.require(sieves.size() >= 2 && std::is_sorted(sieves.begin(), sieves.end(), std::less_equal<>()), {"sieves"},
                    "must be two sizes or more, each above the one before");
    visitor.require(passing.size() == sieves.size(), {"passing", "sieves"}, "must hold one fraction for each sieve");
    visitor.require(passing.empty() ||
                        (std::is_sorted(passing.begin(), passing.end()) && passing.front() == 0 && passing.back() == 1),
                    {"passing"}, "must rise from \"0 %\" at the first sieve to \"100 %\" at the last");
  }
  bool operator==(const SieveCurve&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& random) const {
    double total = 0;
    for (std::size_t c = 0; c + 1 < sieves.size(); ++c) total += grains_of(c);
    double left = random.uniform(0, 1) * total;
    std::size_t c = 0;
    for (; c + 2 < sieves.size() && left >= grains_of(c); ++c) left -= grains_of(c);
    const double share = grains_of(c) > 0 ? std::clamp(left / grains_of(c), 0.0, 1.0) : 0.0;
    return 1 / (1 / sieves[c] - share * (1 / sieves[c] - 1 / sieves[c + 1]));
  }
  double largest() const { return sieves.empty() ? 0 : sieves.back(); }
  double smallest() const { return sieves.empty() ? 0 : sieves.front(); }

 private:
  /// Grains between sieves c and c + 1, per mass of all.
  double grains_of(std::size_t c) const { return (passing[c + 1] - passing[c]) / (sieves[c] * sieves[c + 1]); }
};

}  // namespace arenite::packing
