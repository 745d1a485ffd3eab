#include "grains/dem/programme.hpp"

#include <algorithm>
#include <cmath>

namespace arenite::dem {

double Programme::at(double time) const {
  if (const double period = table.back().x; repeat && period > 0) time -= period * std::floor(time / period);
  const auto after =
      std::upper_bound(table.begin(), table.end(), time, [](double t, const Vec2& row) { return t < row.x; });
  if (after == table.begin()) return table.front().y;
  if (after == table.end()) return table.back().y;
  const Vec2 &a = *(after - 1), &b = *after;
  return a.y + (time - a.x) / (b.x - a.x) * (b.y - a.y);
}

double integral(const Programme& p, double time) {
  const double period = p.table.back().x;
  if (p.repeat && period > 0 && time >= period) {
    Programme once = p;
    once.repeat = false;
    const double whole = std::floor(time / period);
    return whole * integral(once, period) + integral(once, time - whole * period);
  }
  double sum = 0, from = 0;
  for (const Vec2& row : p.table) {
    const double to = std::min(time, row.x);
    if (to > from) sum += 0.5 * (p.at(from) + (row.x > time ? p.at(time) : row.y)) * (to - from), from = to;
  }
  return sum + std::max(0.0, time - from) * p.table.back().y;
}

Vec2 gravity_at(const Stage& stage, double time) {
  if (!stage.gravity) return {};
  double g = stage.gravity_size, turned = stage.gravity_angle;
  for (const Programme& p : stage.programmes) {
    if (p.of.is(Programme::What::gravity_size)) g = p.at(time);
    if (p.of.is(Programme::What::gravity_angle)) turned = p.at(time);
  }
  return gravity_along<2>(g, turned);
}

}  // namespace arenite::dem
