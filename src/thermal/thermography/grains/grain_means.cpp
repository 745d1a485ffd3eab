#include "thermal/thermography/grains/grain_means.hpp"

#include <cmath>
#include <cstdint>
#include <limits>
#include <set>

#include "core/problems.hpp"
#include "geometry/union_area.hpp"
#include "model/grain_motion.hpp"
#include "model/lockin_maps.hpp"

namespace arenite::thermography {
namespace {

void check(const PictureGrains& grains, const GrainMeanOptions& o) {
  Problems problems;
  problems.unless(o.share > 0 && o.share <= 1, "the fraction of a grain's area is {}; it must be above 0 and at most 1",
                  o.share);
  std::set<std::int32_t> missing;
  for (const auto m : grains.material) {
    const auto k = static_cast<std::size_t>(m);
    if (m < 0 || k >= o.factor.size() || !(o.factor[k] > 0) || !std::isfinite(o.factor[k])) missing.insert(m);
  }
  for (const auto m : missing)
    if (m < 0) problems.add("some grains have no material; name the material of every grain");
    else problems.add("material {} has no thermoelastic factor above 0; give it, for example \"0.0150 K/MPa\"", m);
  problems.raise();
}

/// Length of the slope of a disk's mean when its centre is shifted, a pixel.
double slope(const LockinMaps& maps, Vec2 centre, double radius) {
  constexpr double step = 0.5;
  const auto mean = [&](Vec2 shift) { return disk_mean(maps, maps.in_phase, centre + shift, radius).mean; };
  return std::hypot(mean({step, 0}) - mean({-step, 0}), mean({0, step}) - mean({0, -step})) / (2 * step);
}

}  // namespace

DiskMean disk_mean(const LockinMaps& maps, const std::vector<float>& map, Vec2 centre, double radius) {
  double sum = 0, squares = 0, area = 0;
  each_pixel_near(centre, radius + 0.5, maps.width, maps.height, [&](int column, int row, std::size_t p) {
    const auto value = static_cast<double>(map[p]), e = static_cast<double>(maps.standard_error[p]);
    if (!std::isfinite(value) || !std::isfinite(e)) return;
    const double covered =
        geometry::disk_window_area(centre, radius, {column - 0.5, column + 0.5, row - 0.5, row + 0.5});
    sum += covered * value;
    squares += covered * covered * e * e;
    area += covered;
  });
  if (area > 0) return {sum / area, std::sqrt(squares) / area, area};
  return {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 0};
}

PeakToPeak grain_means(const LockinMaps& maps, const PictureGrains& grains, const GrainMeanOptions& options) {
  check(grains, options);
  const double to_full = to_peak_to_peak(maps.convention);
  PeakToPeak found;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double radius = grains.radius[i] * std::sqrt(options.share),
                 factor = options.factor[static_cast<std::size_t>(grains.material[i])];
    const DiskMean mean = disk_mean(maps, maps.in_phase, grains.centre[i], radius);
    double error = std::hypot(mean.error, maps.common_error);
    if (const double shift = grains.position_error.empty() ? 0 : grains.position_error[i]; shift > 0 && mean.area > 0)
      error = std::hypot(error, shift * slope(maps, grains.centre[i], radius));
    found.temperature.push_back(to_full * mean.mean);
    found.sigma_hyd.push_back(-to_full * mean.mean / (2 * factor));
    found.error.push_back(std::isfinite(error) ? to_full * error / (2 * factor)
                                               : std::numeric_limits<double>::infinity());
    found.pixels.push_back(mean.area);
  }
  return found;
}

}  // namespace arenite::thermography
