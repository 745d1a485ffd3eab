#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

#include "core/threads.hpp"
#include "thermal/thermography/grain_motion.hpp"
#include "thermal/thermography/grain_scene.hpp"
#include "thermal/thermography/phase_pictures.hpp"

namespace arenite::thermography {
namespace {

void put(LockinMaps& maps, std::size_t p, const Followed& f, double factor, double spread) {
  maps.mean[p] = static_cast<float>(f.mean);
  maps.amplitude[p] = static_cast<float>(factor * std::hypot(f.cosine, f.sine));
  maps.phase[p] = static_cast<float>(std::atan2(f.sine, f.cosine));
  if (!maps.second_harmonic.empty()) maps.second_harmonic[p] = static_cast<float>(factor * std::hypot(f.cosine2, f.sine2));
  const double noise = std::sqrt(f.variance);
  maps.residual[p] = static_cast<float>(noise);
  maps.standard_error[p] = static_cast<float>(spread * noise);
  maps.noise_floor[p] = static_cast<float>(std::sqrt(std::numbers::pi / 2) * spread * noise);
}

void project(LockinMaps& maps) {
  for (std::size_t p = 0; p < maps.size(); ++p) {
    const double angle = static_cast<double>(maps.phase[p]) - maps.reference_phase, a = static_cast<double>(maps.amplitude[p]);
    maps.in_phase[p] = static_cast<float>(a * std::cos(angle));
    maps.quadrature[p] = static_cast<float>(a * std::sin(angle));
  }
}

/// The grain whose rim is furthest out of a pixel: neighbours may overlap in a picture, but each pixel follows one grain.
std::vector<std::int32_t> owners(const PictureGrains& grains, int width, int height) {
  std::vector<std::int32_t> owner(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), -1);
  std::vector<double> depth(owner.size(), 0);
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const double x = grains.x[i], y = grains.y[i], r = grains.radius[i];
    each_pixel_near(x, y, r, width, height, [&](int column, int row, std::size_t p) {
      const double inside = r - std::hypot(column - x, row - y);
      if (inside < 0 || (owner[p] >= 0 && inside <= depth[p])) return;
      owner[p] = static_cast<std::int32_t>(i);
      depth[p] = inside;
    });
  }
  return owner;
}

/// Where rims sweep over a pixel it shows their motion and no warming.
void forget_outside(LockinMaps& maps, const std::vector<std::int32_t>& owner) {
  for (auto* map : {&maps.amplitude, &maps.phase, &maps.in_phase, &maps.quadrature, &maps.second_harmonic, &maps.standard_error, &maps.residual})
    for (std::size_t p = 0; p < map->size(); ++p)
      if (owner[p] < 0) (*map)[p] = std::numeric_limits<float>::quiet_NaN();
}

std::vector<double> joined(const std::vector<std::vector<double>>& parts) {
  std::vector<double> all;
  for (const auto& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

}  // namespace

LockinMaps follow_grains(const PhasePictures& pictures, const LockinMaps& maps, const PictureGrains& grains, const GrainMotion& motion,
                         const PictureGrains& shown, std::optional<double> given_phase, int threads, double blur) {
  LockinMaps result = maps;
  const double factor = maps.convention == AmplitudeConvention::peak_to_peak ? 2 : 1,
               spread = factor * std::sqrt(2 * maps.noise_ratio / static_cast<double>(maps.frames));
  const GrainScene scene = grain_scene(pictures, grains, motion, blur, threads);
  const PhasePictures rest = without_scene(pictures, scene, grains, motion, blur, threads);
  const std::vector<std::int32_t> owner = owners(shown, maps.width, maps.height);
  std::vector<std::vector<double>> cosine(grains.size()), sine(grains.size());
  const auto follow = [&](std::size_t i) {
    const PixelHarmonics fit(rest, motion.cos_x[i], motion.sin_x[i], motion.cos_y[i], motion.sin_y[i]);
    const double x = shown.x[i], y = shown.y[i], r = shown.radius[i];
    each_pixel_near(x, y, r, maps.width, maps.height, [&](int column, int row, std::size_t p) {
      const double out = std::hypot(column - x, row - y);
      if (out > r || owner[p] != static_cast<std::int32_t>(i)) return;
      Followed f = fit.follow(rest, column + grains.x[i] - x, row + grains.y[i] - y);
      f.mean += scene.grain[i];
      put(result, p, f, factor, spread);
      if (out > 0.7 * r) return;
      cosine[i].push_back(f.cosine);
      sine[i].push_back(f.sine);
    });
  };
  Team(threads).for_each(grains.size(), follow);
  if (given_phase) result.reference_phase = *given_phase;
  else if (grains.size() > 0) result.reference_phase = reference_phase(joined(cosine), joined(sine));
  project(result);
  forget_outside(result, owner);
  return result;
}

}  // namespace arenite::thermography
