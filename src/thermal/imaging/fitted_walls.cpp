#include "thermal/imaging/fitted_walls.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

namespace arenite::imaging {
namespace {

constexpr double beyond_counts = 1.5;  // rims on a wall that one beyond it outweighs
constexpr double clearly = 3;          // rim errors
constexpr int wall_rounds = 10;

/// How well a wall at this place, m inwards, fits gaps between rims and the wall as it was said to be.
double support(const std::vector<double>& gaps, double at, double error, double reach) {
  double sum =
      0.5 * std::exp(-0.5 * std::pow(2 * at / reach, 2));  // where nothing else decides, it is where it was said to be
  for (const double gap : gaps) {
    const double off = (gap - at) / error;
    sum += off < -clearly ? -beyond_counts : std::exp(-0.5 * off * off);
  }
  return sum;
}

FittedWall fitted(const std::vector<double>& gaps, double error, double reach) {
  FittedWall wall;
  double best = 0;
  for (const double gap : gaps)
    if (const double here = support(gaps, gap, error, reach); std::abs(gap) < reach && here > best)
      best = here, wall.shift = gap;
  double squares = 0, weights = 0;
  for (int round = 0; round < wall_rounds; ++round) {
    double sum = 0;
    squares = weights = 0, wall.touching = 0;
    for (const double gap : gaps) {
      const double off = gap - wall.shift;
      if (std::abs(off) > clearly * error) continue;
      const double weight = std::exp(-0.5 * std::pow(off / error, 2));
      sum += weight * off, squares += weight * off * off, weights += weight, ++wall.touching;
    }
    if (weights > 0) wall.shift += sum / weights;
  }
  if (wall.touching > 0)
    wall.error = std::sqrt(std::max(squares / weights, error * error) / static_cast<double>(wall.touching));
  return wall;
}

}  // namespace

BySide<FittedWall> fit_walls(const Grains& grains, const Domain& domain, double rim_error, double reach) {
  BySide<FittedWall> walls;
  for (int side = left; side <= top; ++side) {
    const auto k = static_cast<std::size_t>(side);
    if (!domain.wall[k].present) continue;
    std::vector<double> gaps;
    for (std::size_t g = 0; g < grains.size(); ++g)
      if (const double gap = domain.depth(side, grains.position[g]) - grains.radius[g]; gap < 2 * reach)
        gaps.push_back(gap);
    std::ranges::sort(gaps);
    walls[k] = fitted(gaps, rim_error, reach);
  }
  return walls;
}

Domain with_fitted_walls(Domain domain, const BySide<FittedWall>& walls) {
  for (int side = left; side <= top; ++side)
    if (const FittedWall& wall = walls[static_cast<std::size_t>(side)]; wall.known())
      domain.wall[static_cast<std::size_t>(side)].position += inward_sign(side) * wall.shift;
  return domain;
}

}  // namespace arenite::imaging
