#include "grains/packing/room.hpp"

#include <numbers>
#include <utility>

#include "grains/packing/population.hpp"

namespace arenite::packing {

Circles::Circles(Grains& grains) : grains_(grains), own_(circle_radii(grains)) { std::swap(grains_.radius, own_); }

Circles::~Circles() { std::swap(grains_.radius, own_); }

Room room_in(double area, const std::vector<double>& circle_radii, const std::vector<double>& own_radii) {
  Room room;
  for (const double r : circle_radii) room.circles += std::numbers::pi * r * r / area;
  for (const double r : own_radii) room.grains += std::numbers::pi * r * r / area;
  return room;
}

}  // namespace arenite::packing
