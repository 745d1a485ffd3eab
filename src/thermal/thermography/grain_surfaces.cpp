#include "thermal/thermography/grain_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace arenite::thermography {
namespace {

constexpr double beyond = 1.5;  // pixels: how far a lens spreads a rim

/// The material of every pixel; -1 between the grains.
std::vector<std::int32_t> material_map(const LockinMaps& maps, const PictureGrains& grains) {
  std::vector<std::int32_t> material(maps.size(), -1);
  std::vector<float> away(maps.size(), std::numeric_limits<float>::infinity());
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double reach = grains.radius[g] + beyond;
    const auto from = [](double v) { return std::max(0, static_cast<int>(std::ceil(v))); };
    for (int y = from(grains.y[g] - reach); y < maps.height && y <= grains.y[g] + reach; ++y)
      for (int x = from(grains.x[g] - reach); x < maps.width && x <= grains.x[g] + reach; ++x) {
        const auto at = static_cast<std::size_t>(y) * static_cast<std::size_t>(maps.width) + static_cast<std::size_t>(x);
        const auto distance = static_cast<float>(std::hypot(x - grains.x[g], y - grains.y[g]) - grains.radius[g]);
        if (distance > beyond || distance >= away[at]) continue;
        away[at] = distance;
        material[at] = grains.material[g];
      }
  }
  return material;
}

}  // namespace

void see_surfaces(LockinMaps& maps, const PictureGrains& grains, const GrainSurfaces& surfaces) {
  const auto as_assumed = [&](double e) { return e == surfaces.assumed.emissivity; };
  if (std::all_of(surfaces.emissivity.begin(), surfaces.emissivity.end(), as_assumed)) return;
  const auto material = material_map(maps, grains);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (material[i] < 0 || !std::isfinite(maps.mean[i])) continue;
    const double emissivity = surfaces.emissivity[static_cast<std::size_t>(material[i])];
    const auto true_one = radiometry::taken_for_another(surfaces.band, surfaces.assumed, {emissivity, surfaces.assumed.ambient}, static_cast<double>(maps.mean[i]));
    maps.mean[i] = static_cast<float>(true_one.temperature);
    for (auto* map : {&maps.drift, &maps.amplitude, &maps.in_phase, &maps.quadrature, &maps.standard_error, &maps.noise_floor, &maps.second_harmonic, &maps.residual})
      if (!map->empty()) (*map)[i] *= static_cast<float>(true_one.factor);
  }
}

}  // namespace arenite::thermography
