#include "thermal/inference/stress_errors.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/median.hpp"
#include "model/grain_motion.hpp"
#include "model/lockin_maps.hpp"
#include "thermal/thermography/grains/grain_means.hpp"

namespace arenite::inference {

void add_blur_error(PeakToPeak& change, const PeakToPeak& wider, double step, double blur_error) {
  for (std::size_t i = 0; i < change.size(); ++i) {
    const double slope = (wider.sigma_hyd[i] - change.sigma_hyd[i]) / step;
    if (std::isfinite(slope)) change.error[i] = std::hypot(change.error[i], slope * blur_error);
  }
}

double blur_error(double seen_at_rims, double assumed) {
  constexpr double least = 0.05;
  return std::max(least, seen_at_rims > 0 ? std::abs(seen_at_rims - assumed) : 0);
}

void add_fit_error(FilmResult& r, const PictureGrains& shown, double share) {
  if (r.fit.picture.empty()) return;
  const double to_full = to_peak_to_peak(r.maps.convention);
  const std::size_t materials = r.packing.materials.size();
  std::vector<double> difference(shown.size(), std::nan(""));
  std::vector<std::vector<double>> of(materials);
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto m = static_cast<std::size_t>(shown.material[i]);
    const double radius = shown.radius[i] * std::sqrt(share);
    const auto mean = [&](const std::vector<float>& map) {
      return thermography::disk_mean(r.maps, map, shown.centre[i], radius).mean;
    };
    const double off = std::abs(to_full * mean(r.maps.in_phase) - mean(r.fit.picture)) /
                       (2 * r.packing.materials[m].thermoelastic_factor);
    if (!std::isfinite(off)) continue;
    difference[i] = off;
    of[m].push_back(off);
  }
  std::vector<double> common;
  for (auto& values : of) common.push_back(median(std::move(values)) / median_of_normal_size);
  for (std::size_t i = 0; i < shown.size(); ++i)
    if (std::isfinite(difference[i]))
      r.peak_to_peak.error[i] =
          std::hypot(r.peak_to_peak.error[i], common[static_cast<std::size_t>(shown.material[i])], 0.5 * difference[i]);
}

void add_halo_error(FilmResult& r, const PeakToPeak& scattered) {
  constexpr double least = 0.05;  // share of what a halo does that its shape leaves unknown
  const double unknown = std::max(least, r.halo.error / r.halo.share);
  double squares = 0, sum = 0;
  for (std::size_t i = 0; i < scattered.size(); ++i) {
    const double off = scattered.sigma_hyd[i] - r.peak_to_peak.sigma_hyd[i];
    if (!std::isfinite(off)) continue;
    squares += off * off, sum += r.peak_to_peak.sigma_hyd[i];
    r.peak_to_peak.error[i] = std::hypot(r.peak_to_peak.error[i], unknown * off);
  }
  const auto n = static_cast<double>(scattered.size());
  r.halo.cost = sum != 0 ? std::sqrt(squares / n) / std::abs(sum / n) : 0;
}

void add_factor_error(const GivenFactors& given, FilmResult& r) {
  const bool known = given.with_load && !r.fit.factor_scale.empty();
  for (std::size_t i = 0; i < r.peak_to_peak.size(); ++i) {
    const auto m = static_cast<std::size_t>(r.packing.grains.material[i]);
    double& stress = r.peak_to_peak.sigma_hyd[i];
    double& error = r.peak_to_peak.error[i];
    double relative = given.error;
    if (known) {
      const double scale = r.fit.factor_scale[m];
      const double shown = r.fit.factor_scale_error[m] / scale, off = std::log(scale);
      // Factors that the film shows worse than they were given are the given ones, unless it shows that these are
      // wrong.
      constexpr double errors = 3;
      const double known_to = std::abs(off) > errors * shown ? std::max(given.error, std::abs(off)) : given.error;
      const double believed = known_to > 0 && shown > known_to ? known_to / shown : 1;
      relative = given.fitted ? shown : std::hypot(believed * shown, believed * believed * off);
      if (given.fitted) stress /= scale, error /= scale;
    }
    error = std::hypot(error, relative * stress);
  }
}

}  // namespace arenite::inference
