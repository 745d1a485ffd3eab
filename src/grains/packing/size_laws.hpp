#pragma once
#include <algorithm>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <functional>
#include <variant>
#include <vector>

#include "core/parameters.hpp"
#include "core/random.hpp"

namespace arenite::packing {

struct FixedSize {
  double diameter = 0;  ///< m

  static constexpr Word word{"fixed", "one diameter"};
  void declare(ParameterVisitor& visitor) { visitor.number({"diameter", "The diameter.", true}, diameter, "mm", range::positive); }
  bool operator==(const FixedSize&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& /*random*/) const { return diameter; }
  double largest() const { return diameter; }
};

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
};

/// Throws InputError: the truncation of a law leaves almost none of its grains. Lengths in m.
[[noreturn]] void refuse_truncation(const UniformSizes& law, const char* name, const char* centre);

/// Draws until a diameter lies between min and max. Throws InputError where these lie far out in the tail; a recipe keeps the law's centre between them.
template <class Draw> double truncated(const UniformSizes& law, const char* name, const char* centre, Draw&& draw) {
  for (int attempt = 0; attempt < 100'000; ++attempt)
    if (const double d = draw(); d >= law.min && d <= law.max) return d;
  refuse_truncation(law, name, centre);
}

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

struct SizeList {
  std::vector<double> values;  ///< diameters, m

  static constexpr Word word{"list", "the values in turn, repeated cyclically"};
  void declare(ParameterVisitor& visitor) {
    visitor.numbers({"values", "The diameters.", true}, values, "mm", range::positive);
    visitor.require(!values.empty(), {"values"}, "must hold at least one diameter");
  }
  bool operator==(const SizeList&) const = default;

  double draw(std::int64_t k, RandomStream& /*random*/) const { return values[static_cast<std::size_t>(k) % values.size()]; }
  double largest() const { return values.empty() ? 0 : *std::max_element(values.begin(), values.end()); }
};

/// Number density ~ d^-exponent between min and max (fragments, fractal gradings), by the inverse of its distribution.
struct PowerLawSizes : UniformSizes {
  double exponent = 2;

  static constexpr Word word{"power_law", "number of grains as diameter^-exponent, between min and max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"exponent", "Of the number density; 1 + D for a fractal dimension D of the numbers above a size.", true}, exponent, "",
                   range::between(-10, 10));
    UniformSizes::declare(visitor);
  }
  bool operator==(const PowerLawSizes&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& random) const {
    const double u = random.uniform(0, 1), p = 1 - exponent;
    if (std::abs(p) < 1e-9) return min * std::pow(max / min, u);
    return std::min(max, min * std::pow(1 + u * std::expm1(p * std::log(max / min)), 1 / p));
  }
};

/// Logarithms of diameters are Gaussian; drawn again until it lies between min and max.
struct LogNormalSizes : UniformSizes {
  double median = 0, spread = 0;  ///< before the truncation: m, and the standard deviation of ln d

  static constexpr Word word{"log_normal", "log-normal distribution, truncated to min..max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"median", "Median diameter before truncation.", true}, median, "mm", range::positive);
    visitor.number({"spread", "Standard deviation of the natural logarithm of the diameter.", true}, spread, "", range::between(0, 5));
    UniformSizes::declare(visitor);
    visitor.require(median >= min && median <= max, {"median", "min", "max"}, "must lie between min and max");
  }
  bool operator==(const LogNormalSizes&) const = default;

  double draw(std::int64_t /*k*/, RandomStream& random) const {
    return truncated(*this, "log-normal", "median", [&] { return median * std::exp(spread * random.normal()); });
  }
};

/// P(D > d) = exp(-(d/scale)^shape) by number (Rosin-Rammler), truncated to min..max by the inverse of its distribution.
struct WeibullSizes : UniformSizes {
  double scale = 0, shape = 1;  ///< m, 1

  static constexpr Word word{"weibull", "Weibull (Rosin-Rammler) by number, truncated to min..max"};
  void declare(ParameterVisitor& visitor) {
    visitor.number({"scale", "Diameter exceeded by 1/e of the grains, before truncation.", true}, scale, "mm", range::positive);
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

/// A grading curve by mass: between two sieves mass is spread evenly over diameters. Cylinders of one length weigh as d^2, so the number of grains
/// of a class is its mass times the mean of 1/d^2, and 1/d of its grains is spread evenly.
struct SieveCurve {
  std::vector<double> sieves, passing;  ///< m, rising; share of the mass below each, 0 to 1

  static constexpr Word word{"sieve_curve", "a grading curve by mass: sieve sizes and the fraction passing each"};
  void declare(ParameterVisitor& visitor) {
    visitor.numbers({"sieves", "Sizes of the sieves, rising.", true}, sieves, "mm", range::positive);
    visitor.numbers({"passing", "Fraction of the mass that passes each, from 0 at the first to 1 at the last.", true}, passing, "%", range::between(0, 1));
    visitor.require(sieves.size() >= 2 && std::is_sorted(sieves.begin(), sieves.end(), std::less_equal<>()), {"sieves"},
                    "must be two sizes or more, each above the one before");
    visitor.require(passing.size() == sieves.size(), {"passing", "sieves"}, "must hold one share for each sieve");
    visitor.require(passing.empty() || (std::is_sorted(passing.begin(), passing.end()) && passing.front() == 0 && passing.back() == 1), {"passing"},
                    "must rise from \"0 %\" at the first sieve to \"100 %\" at the last");
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

 private:
  /// Grains between sieves c and c + 1, per mass of all.
  double grains_of(std::size_t c) const { return (passing[c + 1] - passing[c]) / (sieves[c] * sieves[c + 1]); }
};

/// What a size law gives: its word in recipes, its own parameters (name, unit, range and sentence each), equality, and diameters.
template <class L>
concept DrawsDiameters = std::default_initializable<L> && std::equality_comparable<L> && requires(L law, ParameterVisitor& visitor, RandomStream& random) {
  { L::word } -> std::convertible_to<Word>;
  { law.declare(visitor) } -> std::same_as<void>;
  { law.draw(std::int64_t{}, random) } -> std::same_as<double>;  // of grain k of its population, m
  { law.largest() } -> std::same_as<double>;                     // no grain is wider, m
};
template <DrawsDiameters... Law> using SizeLaws = std::variant<Law...>;

/// The size laws there are, the usual one first. A new one is a struct beside these and a word here: recipe keys, their documentation and hashes follow.
using SizeLaw = SizeLaws<FixedSize, UniformSizes, NormalSizes, SizeList, PowerLawSizes, LogNormalSizes, WeibullSizes, SieveCurve>;

}  // namespace arenite::packing
