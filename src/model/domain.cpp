#include "model/domain.hpp"

namespace arenite {

Vec2 mean_point(const std::vector<Vec2>& points) {
  Vec2 sum;
  for (const Vec2& p : points) sum += p;
  return points.empty() ? sum : sum / static_cast<double>(points.size());
}

int Domain::elements() const {
  std::size_t points = 0;
  for (const Boundary& boundary : boundaries) points += boundary.points.size();
  return static_cast<int>(2 * points);
}

int Domain::boundary_of(int element) const {
  for (std::size_t b = 0; b < boundaries.size(); ++b) {
    const int own = static_cast<int>(2 * boundaries[b].points.size());
    if (element < own) return static_cast<int>(b);
    element -= own;
  }
  return -1;
}

}  // namespace arenite
