#include <numbers>

#include "grains/texture/statistics.hpp"
#include "grains/texture/stress.hpp"

namespace arenite::texture {

namespace {

/// What a laboratory could not measure is NaN, and no part of the mean.
void take_measured(const View& view, PerGrain& rows) {
  rows.sigma_hyd = view.options.grain_sigma_hyd;
  const double mean = mean_of_known(view.grains, rows.sigma_hyd);
  for (const double value : rows.sigma_hyd) rows.sigma_norm.push_back(mean != 0 ? value / mean : 0);
}

}  // namespace

/// Stress of every grain over its own volume (T eq. 1.11). The normalised stress needs no length, since it cancels.
void measure_grain_stress(const View& view, Texture& texture) {
  if (!view.options.grain_sigma_hyd.empty()) return take_measured(view, texture.per_grain);
  const Grains& grains = view.packing.grains;
  const std::vector<Tensor2> moments = grain_moments(view.packing);
  PerGrain& rows = texture.per_grain;
  std::vector<double> per_length;  // sigma_hyd times the length, N/m
  double mean = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double area = std::numbers::pi * grains.radius[g] * grains.radius[g];
    per_length.push_back(0.5 * trace(moments[g]) / area);
    if (view.considered[g]) mean += per_length[g] / static_cast<double>(view.grains.size());
    if (!view.has_thickness) continue;
    const double length = view.packing.domain.thickness;
    rows.sigma.push_back(1 / (area * length) * moments[g]);
    rows.sigma_hyd.push_back(per_length[g] / length);
  }
  for (const double value : per_length) rows.sigma_norm.push_back(mean != 0 ? value / mean : 0);
}

}  // namespace arenite::texture
