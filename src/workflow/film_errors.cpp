#include "workflow/film_errors.hpp"

#include <cmath>
#include <vector>

#include "core/median.hpp"
#include "thermal/thermography/grain_means.hpp"

namespace arenite::study {

void add_blur_error(GrainSwing& swing, const GrainSwing& wider, double step, double blur_error) {
  for (std::size_t i = 0; i < swing.size(); ++i) {
    const double slope = (wider.sigma_hyd[i] - swing.sigma_hyd[i]) / step;
    if (std::isfinite(slope)) swing.error[i] = std::hypot(swing.error[i], slope * blur_error);
  }
}

void add_fit_error(FilmResult& r, const PictureGrains& shown, double share) {
  if (r.fit.picture.empty()) return;
  const double to_full = r.maps.convention == SwingConvention::full ? 1 : 2;
  const std::size_t materials = r.packing.materials.size();
  std::vector<double> difference(shown.size(), std::nan(""));
  std::vector<std::vector<double>> of(materials);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto m = static_cast<std::size_t>(shown.material[i]);
    const double radius = shown.radius[i] * std::sqrt(share);
    const auto mean = [&](const std::vector<float>& map) {
      return thermography::disk_mean(map, r.maps.standard_error, r.maps.width, r.maps.height, shown.x[i], shown.y[i], radius).mean;
    };
    const double off = std::abs(to_full * mean(r.maps.in_phase) - mean(r.fit.picture)) / (2 * r.packing.materials[m].thermoelastic_factor);
    if (!std::isfinite(off)) continue;
    difference[i] = off;
    of[m].push_back(off);
  }
  std::vector<double> common;
  for (auto& values : of) common.push_back(median(std::move(values)) / median_of_normal_size);
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (std::isfinite(difference[i]))
      r.swing.error[i] = std::hypot(r.swing.error[i], common[static_cast<std::size_t>(shown.material[i])], 0.5 * difference[i]);
}

}  // namespace arenite::study
