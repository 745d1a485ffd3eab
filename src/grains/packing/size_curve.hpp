#pragma once
#include <vector>

#include "grains/packing/population.hpp"
#include "model/packing.hpp"

namespace arenite::packing {

/// A grading curve: share of the mass in grains no wider than each diameter; between two points it keeps the value of the first.
struct SizeCurve {
  std::vector<double> diameter;  ///< m, rising
  std::vector<double> passing;   ///< 0 to 1
};

/// Of grains as cylinders of one length, with the densities of their materials; at most `most` points, evenly spaced in mass.
SizeCurve measured_size_curve(const Grains& grains, const Materials& materials, std::size_t most = 200);

/// That of the populations' laws themselves: of very many grains drawn from them in the shares that `total` grains have.
SizeCurve asked_size_curve(const std::vector<Population>& populations, const Materials& materials, std::int64_t total, std::size_t most = 200);

}  // namespace arenite::packing
