#include "thermal/imaging/grains_of_picture.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include "core/mapped.hpp"
#include "core/median.hpp"
#include "core/problems.hpp"
#include "statistics/clusters.hpp"

namespace arenite::imaging {
namespace {

/// What a picture's noise does not tell of the errors of circles shows in the radii of one class, which are alike: by
/// how much they scatter more than their errors say.
double scatter_of_radii(const FoundCircles& found) {
  std::vector<double> off;
  for (std::size_t i = 0; i < found.grains.size(); ++i)
    if (const auto k = found.grains.size_class[i]; k >= 0 && found.grains.radius_error[i] > 0)
      off.push_back(std::abs(found.grains.radius[i] - found.report.sizes.mean[static_cast<std::size_t>(k)]) /
                    found.grains.radius_error[i]);
  return std::clamp(median(std::move(off)) / median_of_normal_size, 1.0, 10.0);
}

}  // namespace

FoundCircles circles_of(const std::vector<double>& radii, const FloatImage& picture, double pixel,
                        CircleOptions options) {
  for (const double r : radii) options.radii.push_back(r / pixel);
  auto found = find_circles(picture, options);
  const double times = scatter_of_radii(found);
  for (auto* errors : {&found.grains.position_error, &found.grains.radius_error})
    for (double& error : *errors) error *= times;
  for (std::size_t i = 0; i < found.grains.size(); ++i)
    if (const auto k = found.grains.size_class[i]; k >= 0)
      found.grains.radius[i] = found.report.sizes.mean[static_cast<std::size_t>(k)];
  return found;
}

void take_materials(const std::vector<double>& brightness, const std::string& where, PictureGrains& grains) {
  const auto order = ordered_by(brightness.size(), [&](std::size_t m) { return brightness[m]; });
  const auto classes = statistics::cluster(grains.brightness, {.most = order.size()});
  if (classes.size() != order.size())
    throw refusal(
        "grains in {} have {} {} of brightness, and the recipe {} materials; give an optical picture in which they "
        "differ (picture.optical) or a list of the grains (picture.grains)",
        where, classes.size(), classes.size() == 1 ? "kind" : "kinds", order.size());
  grains.material.clear();
  for (const auto k : classes.of)
    grains.material.push_back(static_cast<std::int32_t>(order[static_cast<std::size_t>(k)]));
}

}  // namespace arenite::imaging
