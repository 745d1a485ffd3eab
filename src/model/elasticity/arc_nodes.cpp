#include "model/elasticity/arc_nodes.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace arenite::elasticity {
namespace {

constexpr std::array<int, 5> sizes{4, 8, 16, 32, 96};

ArcNodes make_nodes(Traction traction, int n) {
  ArcNodes nodes;
  for (int k = 1; k <= n; ++k) {
    const double angle = k * std::numbers::pi / (n + 1);
    double even = 0;
    for (int j = 1; j <= (n + 1) / 2; ++j) even += std::sin((2 * j - 1) * angle) / (2 * j - 1);
    const double elliptic = 2.0 / (n + 1) * std::sin(angle) * std::sin(angle);
    nodes.place.push_back(std::cos(angle));
    nodes.share.push_back(traction == Traction::uniform ? 2.0 / (n + 1) * std::sin(angle) * even : elliptic);
  }
  return nodes;
}

std::array<ArcNodes, sizes.size()> make_table(Traction traction) {
  std::array<ArcNodes, sizes.size()> table;
  for (std::size_t s = 0; s < sizes.size(); ++s) table[s] = make_nodes(traction, sizes[s]);
  return table;
}

}  // namespace

const ArcNodes& arc_nodes(Traction traction, double distance) {
  static const ArcNodes point{{0}, {1}};
  static const auto uniform = make_table(Traction::uniform), elliptic = make_table(Traction::elliptic);
  if (traction == Traction::point) return point;
  const std::size_t size = distance > 20 ? 0 : distance > 4 ? 1 : distance > 1.5 ? 2 : distance > 0.6 ? 3 : 4;
  return traction == Traction::uniform ? uniform[size] : elliptic[size];
}

}  // namespace arenite::elasticity
