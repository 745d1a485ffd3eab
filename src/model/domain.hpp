#pragma once
#include <array>

#include "core/vec2.hpp"

namespace arenite {

/// The four rigid planes of a frame, in this order everywhere (arrays, files, figures).
enum Side : int { left = 0, right = 1, bottom = 2, top = 3 };
inline constexpr std::array<const char*, 4> side_names{"left", "right", "bottom", "top"};

/// Unit normal of a wall, into the sample.
constexpr Vec2 inward_normal(int side) {
  constexpr Vec2 normals[4] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  return normals[side];
}

/// One rigid plane. `position` is its x (left, right) or y (bottom, top).
struct Wall {
  bool present = true;
  double position = 0;    ///< m
  double velocity = 0;    ///< m/s, along +x or +y
  double force = 0;       ///< normal force that the grains exert on it, N, compression positive
  double shear_force = 0; ///< tangential force that the grains exert on it, N, along +y (left, right) or +x (bottom, top)
};

/// What holds the sample: four walls, or periodic sides (then the walls of that direction are absent, and their
/// positions are the edges of the cell).
struct Domain {
  std::array<Wall, 4> wall;
  bool periodic_x = false, periodic_y = false;
  double tilt = 0;        ///< x-shift of the upper image of a sheared periodic cell (Lees-Edwards), m
  double thickness = 1;   ///< out-of-plane length L of the cylinders, m

  double width() const { return wall[right].position - wall[left].position; }
  double height() const { return wall[top].position - wall[bottom].position; }
  double area() const { return width() * height(); }
  /// The nearest periodic image of a vector between two points; the vector itself where nothing is periodic.
  Vec2 nearest_image(Vec2 d) const;
};

}  // namespace arenite
