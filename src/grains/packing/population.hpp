#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "model/grains.hpp"
#include "model/material.hpp"

namespace arenite::packing {

/// A size law of one population; diameters in m.
struct SizeLaw {
  enum class Kind { fixed, uniform, normal, list };
  Kind kind = Kind::fixed;
  double diameter = 0;                 ///< fixed
  double min = 0, max = 0;             ///< uniform; cut of normal
  double mean = 0, deviation = 0;      ///< normal
  std::vector<double> values;          ///< list: taken in turn, from the start again when used up
  bool operator==(const SizeLaw&) const = default;
};

/// Grains of one material and size law; a count, or a share by number of a total.
struct Population {
  std::string material;
  std::optional<std::int64_t> count;
  std::optional<double> ratio;         ///< relative to the other populations' ratios
  SizeLaw size;
  bool operator==(const Population&) const = default;
};

/// Grains of all populations, in random order, at rest at the origin: radius, material and id are set. Populations
/// with a ratio share `total` less the counts, by largest remainder. Same seed: same grains.
/// Throws InputError for an unknown material or a total that leaves no grain.
Grains draw_grains(const std::vector<Population>& populations, const Materials& materials, std::int64_t total,
                   std::uint64_t seed);

}  // namespace arenite::packing
