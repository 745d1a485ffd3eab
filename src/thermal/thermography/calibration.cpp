#include "thermal/thermography/calibration.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

#include "core/error.hpp"

namespace arenite::thermography {
namespace {

/// So many numbers that what lies between them is straight to a thousandth of what a camera resolves.
constexpr std::size_t numbers = 8193;

template <class Law> LevelCurve tabulate(const LevelRange& range, Law&& law) {
  LevelCurve curve;
  curve.first = range.low;
  curve.step = (range.high - range.low) / static_cast<double>(numbers - 1);
  if (!(curve.step > 0))
    throw InputError(fmt::format("levels from {} to {} are no range for a calibration curve; give a lower and a higher one", range.low, range.high));
  for (std::size_t i = 0; i < numbers; ++i) curve.temperature.push_back(static_cast<float>(law(range.low + static_cast<double>(i) * curve.step)));
  return curve;
}

void check(const std::vector<LevelPoint>& points) {
  if (points.size() < 2) throw InputError(fmt::format("a calibration curve of {} points is too short; give 2 or more", points.size()));
  for (const LevelPoint& p : points)
    if (!std::isfinite(p.level) || !(p.temperature > 0) || !std::isfinite(p.temperature))
      throw InputError(fmt::format("a calibration curve has the point ({}, {} K), which cannot be; correct it", p.level, p.temperature));
}

constexpr double beyond = 1.5;  // pixels: how far a lens spreads a rim

/// The material of every pixel; -1 between the grains.
std::vector<std::int32_t> material_map(const LockinMaps& maps, const PictureGrains& grains) {
  std::vector<std::int32_t> material(maps.size(), -1);
  std::vector<float> away(maps.size(), std::numeric_limits<float>::infinity());
  for (std::size_t g = 0; g < grains.size(); ++g)
    each_pixel_near(grains.x[g], grains.y[g], grains.radius[g] + beyond, maps.width, maps.height, [&](int x, int y, std::size_t at) {
      const auto distance = static_cast<float>(std::hypot(x - grains.x[g], y - grains.y[g]) - grains.radius[g]);
      if (distance > beyond || distance >= away[at]) return;
      away[at] = distance;
      material[at] = grains.material[g];
    });
  return material;
}

}  // namespace

LevelCurve curve_through(std::vector<LevelPoint> points, const LevelRange& range) {
  check(points);
  std::sort(points.begin(), points.end(), [](const LevelPoint& a, const LevelPoint& b) { return a.level < b.level; });
  for (std::size_t i = 1; i < points.size(); ++i)
    if (!(points[i].level > points[i - 1].level) || !(points[i].temperature > points[i - 1].temperature))
      throw InputError(fmt::format("a calibration curve does not rise from level {} to {}; correct its points", points[i - 1].level, points[i].level));
  std::size_t k = 1;
  return tabulate(range, [&](double level) {
    while (k + 1 < points.size() && level > points[k].level) ++k;
    const LevelPoint &a = points[k - 1], &b = points[k];
    return a.temperature + (level - a.level) * (b.temperature - a.temperature) / (b.level - a.level);
  });
}

LevelCurve curve_through(std::vector<LevelPoint> points, const radiometry::Band& band, const radiometry::Surface& surface, const LevelRange& range) {
  LevelCurve curve = curve_through(std::move(points), range);
  if (surface.emissivity == 1) return curve;
  for (float& t : curve.temperature)
    t = static_cast<float>(radiometry::temperature_of_seen(band, surface, radiometry::photon_exitance(band, static_cast<double>(t))));
  return curve;
}

LevelCurve curve_by_references(const radiometry::Band& band, const LevelPoint& cold, const LevelPoint& warm, const radiometry::Surface& surface,
                               const LevelRange& range) {
  if (!(cold.temperature > 0) || !(warm.temperature > cold.temperature) || cold.level == warm.level)
    throw InputError(fmt::format("references of {} K and {} K at levels {} and {} make no calibration; film a colder and a warmer one", cold.temperature,
                                 warm.temperature, cold.level, warm.level));
  const double low = radiometry::photon_exitance(band, cold.temperature), high = radiometry::photon_exitance(band, warm.temperature);
  return tabulate(range, [&](double level) {
    return radiometry::temperature_of_seen(band, surface, low + (level - cold.level) * (high - low) / (warm.level - cold.level));
  });
}

LevelCurve curve_by_radiometry(const radiometry::Band& band, const LevelPoint& known, const radiometry::Surface& surface, const LevelRange& range) {
  if (!(known.temperature > 0) || !(known.level > 0))
    throw InputError(
        fmt::format("a level of {} at {} K makes no calibration; give a level above 0 and a temperature above 0 K", known.level, known.temperature));
  const double photons = radiometry::photon_exitance(band, known.temperature) / known.level;
  return tabulate(range, [&](double level) { return radiometry::temperature_of_seen(band, surface, photons * level); });
}

void see_surfaces(LockinMaps& maps, const PictureGrains& grains, const GrainSurfaces& surfaces) {
  const auto as_assumed = [&](double e) { return e == surfaces.assumed.emissivity; };
  if (std::all_of(surfaces.emissivity.begin(), surfaces.emissivity.end(), as_assumed)) return;
  const auto material = material_map(maps, grains);
  for (std::size_t i = 0; i < maps.size(); ++i) {
    if (material[i] < 0 || !std::isfinite(maps.mean[i])) continue;
    const double emissivity = surfaces.emissivity[static_cast<std::size_t>(material[i])];
    const auto true_one =
        radiometry::taken_for_another(surfaces.band, surfaces.assumed, {emissivity, surfaces.assumed.ambient}, static_cast<double>(maps.mean[i]));
    maps.mean[i] = static_cast<float>(true_one.temperature);
    for (auto* map :
         {&maps.drift, &maps.amplitude, &maps.in_phase, &maps.quadrature, &maps.standard_error, &maps.noise_floor, &maps.second_harmonic, &maps.residual})
      if (!map->empty()) (*map)[i] *= static_cast<float>(true_one.factor);
  }
}

}  // namespace arenite::thermography
