#pragma once
#include <vector>

namespace arenite::raster {

/// Where the probability density of positive volumes is highest, in their unit: the density of their logarithms under a
/// Gaussian kernel of Silverman's width, over the volume. NaN for fewer than two different volumes.
double density_peak(const std::vector<double>& volumes);

}  // namespace arenite::raster
