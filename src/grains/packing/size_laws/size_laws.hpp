#pragma once
#include <concepts>
#include <cstdint>
#include <variant>

#include "grains/packing/size_laws/fixed.hpp"
#include "grains/packing/size_laws/list.hpp"
#include "grains/packing/size_laws/log_normal.hpp"
#include "grains/packing/size_laws/normal.hpp"
#include "grains/packing/size_laws/power.hpp"
#include "grains/packing/size_laws/sieve_curve.hpp"
#include "grains/packing/size_laws/uniform.hpp"
#include "grains/packing/size_laws/weibull.hpp"

namespace arenite::packing {

/// What a size law gives: its word in recipes, its own parameters (name, unit, range and sentence each), equality, and
/// diameters.
template <class L>
concept DrawsDiameters = std::default_initializable<L> && std::equality_comparable<L> &&
    requires(L law, ParameterVisitor& visitor, RandomStream& random) {
  { L::word } -> std::convertible_to<Word>;
  { law.declare(visitor) } -> std::same_as<void>;
  { law.draw(std::int64_t{}, random) } -> std::same_as<double>;  // of grain k of its population, m
  { law.largest() } -> std::same_as<double>;                     // no grain is wider, m
  { law.smallest() } -> std::same_as<double>;                    // or narrower
};
template <DrawsDiameters... Law> using SizeLaws = std::variant<Law...>;

/// The size laws there are, the usual one first. A new one is a file beside these and a word here: recipe keys, their
/// documentation and hashes follow.
using SizeLaw =
    SizeLaws<FixedSize, UniformSizes, NormalSizes, SizeList, PowerLawSizes, LogNormalSizes, WeibullSizes, SieveCurve>;

}  // namespace arenite::packing
