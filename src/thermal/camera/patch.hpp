#pragma once
#include <cmath>

#include "thermal/camera/camera.hpp"

namespace arenite::camera {

constexpr double most_points = 1e8;  ///< of a scene or a picture: minutes of work, and less memory than a laboratory's machine has

/// Throws InputError if the points of the scene in the first `count` grains are more.
void check_points(const Grains& grains, std::size_t count, const Optics& optics);

/// The patch of a grain of that radius, in cells that wide, m. `swing(middle, away)` is the mean of sigma_kk over the cell
/// whose middle lies there, seen from the grain's centre and `away` from it, Pa. It is asked for a ring of cells beyond
/// the rim too, so that what lies between cells can be read off; cells farther out stay 0.
template <class Swing>
Patch fill_patch(double radius, double cell, const Swing& swing) {
  Patch patch;
  patch.cells = 2 * static_cast<int>(std::ceil(radius / cell)) + 2;
  patch.cell = cell;
  const double first = -0.5 * (patch.cells - 1) * cell;
  for (int r = 0; r < patch.cells; ++r)
    for (int c = 0; c < patch.cells; ++c) {
      const Vec2 middle{first + c * cell, first + r * cell};
      const double away = norm(middle);
      patch.value.push_back(away > radius + 1.5 * cell ? 0.0F : static_cast<float>(swing(middle, away)));
    }
  return patch;
}

}  // namespace arenite::camera
