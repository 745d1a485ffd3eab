#pragma once
#include <cmath>
#include <numbers>

#include "core/vec.hpp"
#include "geometry/rectangle.hpp"

namespace arenite::geometry {

/// Area of a disk, m^2, volume of a sphere, m^3.
template <int D> double volume_of_ball(double radius) {
  const double area = std::numbers::pi * radius * radius;
  if constexpr (D == 2) return area;
  else return 4.0 / 3.0 * area * radius;
}

/// A disk (D = 2) or a sphere (3), m.
template <int D> struct Ball {
  Vec<D> centre;
  double radius = 0;
  double volume() const { return volume_of_ball<D>(radius); }
};

/// Side of the square of that area, of the cube of that volume.
template <int D> double side_of_cube(double volume) {
  if constexpr (D == 2) return std::sqrt(volume);
  else return std::cbrt(volume);
}

/// m^D.
template <int D> double volume_of(const Box<D>& box) {
  double product = 1;
  for (int axis = 0; axis < D; ++axis) product *= box.size[axis];
  return product;
}
inline double volume_of(const Rectangle& rectangle) { return rectangle.area(); }

}  // namespace arenite::geometry
