#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "core/random.hpp"
#include "statistics/numbers.hpp"

namespace arenite::texture {

/// Windows of the REV study: sizes, and random places of each.
struct RevWindows {
  int sizes = 20, places = 50;
};

/// Solid fraction of windows of growing size and random place (T Fig. 3.6); all arrays have one length.
struct Rev {
  std::vector<double> share;                   ///< of the box's area, in space of its volume
  std::vector<double> mean, deviation, error;  ///< over places; error = standard error of the mean
};

/// Solid fractions of windows of the box's shape, `side` of its side long, at so many random places in the whole box.
using WindowFractions = std::function<std::vector<double>(double side, int places, RandomStream random)>;

/// Windows from a twentieth of the box's side to 0.98 of it in equal steps of side, which keep the border (T Fig. 3.6),
/// and show its effect at the largest windows. Large windows overlap and know one sample only: to the error of the
/// finite number of places that of the sample itself is added.
Rev growing_windows(const RevWindows& windows, int dimension, std::uint64_t seed, double error_of_sample,
                    const WindowFractions& fractions);

/// As it is stored, its shares under that name.
Numbers numbers_of(const Rev& rev, const char* share);

}  // namespace arenite::texture
