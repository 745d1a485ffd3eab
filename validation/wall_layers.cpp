#include "validation/wall_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "grains/texture/view.hpp"

namespace arenite::validation {

double share_of_interior(double window, double strip) {
  const double room = 1 - window;
  // A window that starts at x < strip holds strip - x of it; x is even between 0 and room. The other end is alike.
  const double lost = room >= strip ? strip * strip / (2 * room) : strip - room / 2;
  return window > strip ? std::max(0.0, 1 - 2 * lost / window) : statistics::unknown;
}

double WallLayers::of_windows(double area_share) const {
  const double side = std::sqrt(area_share);
  return at_walls + (within - at_walls) * share_of_interior(side, strip_x) * share_of_interior(side, strip_y);
}

WallLayers wall_layers(const FinalState& state, double diameters) {
  const Domain& domain = state.packing.domain;
  const double strip = diameters * state.texture.mean_diameter;
  WallLayers layers;
  layers.strip_x = strip / domain.width();
  layers.strip_y = strip / domain.height();
  layers.within = state.texture.solid_fraction.value;
  double covered = 0;
  for (const double r : state.packing.grains.radius) covered += std::numbers::pi * r * r;
  const double inner = (1 - 2 * layers.strip_x) * (1 - 2 * layers.strip_y) * domain.area();
  layers.at_walls = (covered - layers.within * inner) / (domain.area() - inner);
  return layers;
}

texture::Rev rev_within(const FinalState& state) {
  Packing cut = state.packing;
  const texture::Window& window = state.texture.window;
  cut.domain.wall[left].position = window.x_min;
  cut.domain.wall[right].position = window.x_max;
  cut.domain.wall[bottom].position = window.y_min;
  cut.domain.wall[top].position = window.y_max;
  texture::Options options;
  options.border = 0;
  texture::Texture texture;
  texture::rev(texture::View(cut, options), texture);
  return texture.rev;
}

}  // namespace arenite::validation
