#include "thermal/imaging/settled_walls.hpp"

#include <algorithm>
#include <cmath>

#include "thermal/imaging/fitted_walls.hpp"

namespace arenite::imaging {

Domain settle_walls(const FilmContainers& given, const PictureGrains& loaded, FilmPlace& place, FilmResult& r) {
  constexpr double rim_error = 0.08, reach = 3, least = 0.15,
                   errors = 4;  // pixels, and standard errors from which on a shift is believed
  const auto fitted = [&](const PictureGrains& grains, const Domain& container) {
    auto walls = fit_walls(in_metres(grains, place), container, rim_error * place.pixel, reach * place.pixel);
    for (auto& wall : walls)
      if (std::abs(wall.shift) < std::max(least * place.pixel, errors * wall.error)) wall.shift = 0;
    return walls;
  };
  auto before = fitted(r.grains, given.start);
  const auto put = [&](int low, double& shift, double& error) {
    const auto &a = before[static_cast<std::size_t>(low)], &b = before[static_cast<std::size_t>(low) + 1];
    const double both = static_cast<double>(a.known()) + static_cast<double>(b.known());
    if (both == 0) return;
    shift = ((a.known() ? a.shift : 0) - (b.known() ? b.shift : 0)) / both;
    error = std::hypot(a.known() ? a.error : 0, b.known() ? b.error : 0) / both;
    if (std::abs(shift) < std::max(least * place.pixel, errors * error)) shift = 0;
  };
  put(left, r.walls.shift.x, r.walls.shift_error.x), put(bottom, r.walls.shift.y, r.walls.shift_error.y);
  place.origin -= r.walls.shift;
  r.origin = place.origin;
  before = fitted(r.grains, given.start);
  const auto after = fitted(loaded, given.shown);
  const auto smaller = [&](int low) {
    const double by = before[static_cast<std::size_t>(low)].shift + before[static_cast<std::size_t>(low) + 1].shift;
    return std::abs(by) > 2 * least * place.pixel ? by : 0;
  };
  r.walls.smaller = {smaller(left), smaller(bottom)};
  for (std::size_t side = 0; side < after.size(); ++side)
    r.walls.inward[side] = after[side].known() ? after[side].shift : 0;
  if (given.moves && r.walls.inward[bottom] != 0)
    r.walls.travel = given.travel + r.walls.inward[bottom] - before[bottom].shift;
  r.packing.domain = with_fitted_walls(given.shown, after);
  return with_fitted_walls(given.start, before);
}

}  // namespace arenite::imaging
