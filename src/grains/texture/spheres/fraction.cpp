#include <algorithm>
#include <vector>

#include "geometry/ball_window.hpp"
#include "grains/texture/spheres/sphere_view.hpp"

namespace arenite::texture::spheres {

SphereStatistic sphere_fraction;

/// Volume of spheres cut by the window over the window's; an overlap counts in both. Error from equal blocks.
void sphere_fraction(const SphereView& view, Numbers& to) {
  if (!view.has_box) return;
  const BlockCube blocks{view.window, std::max(2, view.blocks.per_side)};
  const double volume = view.window.size.x * view.window.size.y * view.window.size.z;
  std::vector<double> fraction(static_cast<std::size_t>(blocks.count()), 0.0);
  const Container<3>& domain = view.packing.domain;
  const GrainsIn<3>& grains = view.packing.grains;
  for (std::size_t g = 0; g < grains.size(); ++g)
    domain.each_near_cell([&](Cells<3> cells) {
      const Vec3 centre = grains.position[g] + domain.way(cells);
      if (!domain.is_near(centre, grains.radius[g])) return;
      for (int b = 0; b < blocks.count(); ++b)
        fraction[static_cast<std::size_t>(b)] +=
            geometry::ball_window_volume(centre, grains.radius[g], blocks.block(b)) * blocks.count() / volume;
    });
  double mean = 0;
  for (const double of_block : fraction) mean += of_block / static_cast<double>(blocks.count());
  statistics::put(to, "solid_fraction", statistics::Estimate{mean, statistics::standard_error(fraction)}, "",
                  "Solid fraction, volume of grains over volume of the sample");
}

}  // namespace arenite::texture::spheres
