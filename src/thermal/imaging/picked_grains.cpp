#include "thermal/imaging/picked_grains.hpp"

#include <cstdint>
#include <numbers>

#include "core/ranks.hpp"

namespace arenite::imaging {
namespace {

/// Leaves those grains of which `stays` (by their number) says so.
template <class Stays> void keep(PictureGrains& grains, const Stays& stays) {
  std::vector<std::uint8_t> kept;
  for (std::size_t i = 0; i < grains.size(); ++i) kept.push_back(stays(i));
  const auto filter = [&](auto&... arrays) {  // those that are filled
    const auto thin = [&](auto& values) {
      std::size_t i = 0;
      std::erase_if(values, [&](const auto&) { return !kept[i++]; });
    };
    (thin(arrays), ...);
  };
  filter(grains.centre, grains.radius, grains.position_error, grains.radius_error, grains.brightness, grains.score,
         grains.material, grains.size_class);
}

}  // namespace

void keep_inside(Vec2 container, const FilmPlace& place, PictureGrains& grains) {
  keep(grains, [&](std::size_t i) {
    const Vec2 c = place.metres(grains.centre[i]);
    const double deep = 0.5 * grains.radius[i] * place.pixel;
    return c.x > deep && c.x < container.x - deep && c.y > deep && c.y < container.y - deep;
  });
}

double covered_share(Vec2 container, const FilmPlace& place, const PictureGrains& grains) {
  double area = 0;
  for (const double r : grains.radius) area += std::numbers::pi * r * r * place.pixel * place.pixel;
  return area / (container.x * container.y);
}

void drop_overlapping(PictureGrains& grains) {
  std::vector<std::uint8_t> kept(grains.size(), 1);
  each_overlap(grains.centre, grains.radius,
               [&](std::size_t i, std::size_t j, double) { kept[grains.score[i] < grains.score[j] ? i : j] = 0; });
  keep(grains, [&](std::size_t i) { return kept[i]; });
}

void drop_pores(const std::vector<float>& frame, bool bright, PictureGrains& grains) {
  const std::vector<double> levels(frame.begin(), frame.end());
  const double behind = at_share(levels, bright ? 0.02 : 0.98),
               halfway = 0.5 * (behind + at_share(grains.brightness, 0.5));
  keep(grains, [&](std::size_t i) { return bright ? grains.brightness[i] > halfway : grains.brightness[i] < halfway; });
}

}  // namespace arenite::imaging
