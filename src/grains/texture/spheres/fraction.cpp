#include <algorithm>
#include <vector>

#include "geometry/ball_window.hpp"
#include "grains/texture/rev.hpp"
#include "grains/texture/spheres/spheres.hpp"
#include "grains/texture/view.hpp"

namespace arenite::texture::spheres {
namespace {

struct Ball {
  Vec3 centre;
  double radius;
};

/// All that reach into the container: a periodic cell has the images of spheres at its sides, too.
std::vector<Ball> balls_of(const PackingIn<3>& packing) {
  std::vector<Ball> balls;
  const GrainsIn<3>& grains = packing.grains;
  for (std::size_t g = 0; g < grains.size(); ++g)
    packing.domain.each_near_cell([&](Cells<3> cells) {
      const Vec3 centre = grains.position[g] + packing.domain.way(cells);
      if (packing.domain.is_near(centre, grains.radius[g])) balls.push_back({centre, grains.radius[g]});
    });
  return balls;
}

/// Windows at random places lie within the container, those at periodic sides, too.
Rev sphere_windows(const SphereView& view, const std::vector<Ball>& balls, double error_of_sample) {
  const Vec3 corner = view.packing.domain.corner(), size = view.packing.domain.size();
  const auto fractions = [&](double side, int places, RandomStream random) {
    std::vector<double> found;
    for (int p = 0; p < places; ++p) {
      geometry::Box<3> window{corner, side * size};
      for (int axis = 0; axis < 3; ++axis) window.corner[axis] += random.uniform(0.0, size[axis] - window.size[axis]);
      double covered = 0;
      for (const Ball& ball : balls) covered += geometry::ball_window_volume(ball.centre, ball.radius, window);
      found.push_back(covered / (window.size.x * window.size.y * window.size.z));
    }
    return found;
  };
  return growing_windows(view.options.rev, 3, view.options.seed, error_of_sample, fractions);
}

}  // namespace

/// Volume of spheres cut by the window over the window's; an overlap counts in both. Error from equal blocks.
void fraction(const SphereView& view, TextureIn<3>& texture) {
  if (!view.has_box) return;
  const BlockGridIn<3> blocks{view.window, std::max(2, view.blocks.per_side)};
  const double volume = view.window.size.x * view.window.size.y * view.window.size.z;
  std::vector<double> fraction(static_cast<std::size_t>(blocks.count()), 0.0);
  const std::vector<Ball> balls = balls_of(view.packing);
  for (const Ball& ball : balls)
    for (int b = 0; b < blocks.count(); ++b)
      fraction[static_cast<std::size_t>(b)] +=
          geometry::ball_window_volume(ball.centre, ball.radius, blocks.block(b)) * blocks.count() / volume;
  double mean = 0;
  for (const double of_block : fraction) mean += of_block / static_cast<double>(blocks.count());
  texture.solid_fraction = {mean, standard_error(fraction)};
  put(texture.numbers, "solid_fraction", texture.solid_fraction, "",
      "Solid fraction, volume of grains over volume of the sample");
  if (view.options.rev.sizes == 0) return;
  texture.rev = sphere_windows(view, balls, texture.solid_fraction.error);
  texture.numbers["rev"] = numbers_of(texture.rev, "volume_share");
}

}  // namespace arenite::texture::spheres
