#include "solid/peridynamics/cut.hpp"

namespace arenite::peridynamics {

namespace {

bool crosses(const Cut& cut, Vec2 a, Vec2 b) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
  return side(cut.from, cut.to, a) * side(cut.from, cut.to, b) < 0 && side(a, b, cut.from) * side(a, b, cut.to) <= 0;
}

}  // namespace

void make_cuts(Bonds& bonds, const std::vector<Cut>& cuts) {
  if (cuts.empty()) return;
  const Grid& grid = bonds.grid;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x)
      for (int d = 0; d < bonds_per_node; ++d) {
        const Offset e = half_bonds[static_cast<unsigned>(d)];
        const Vec2 a{static_cast<double>(x), static_cast<double>(y)};
        const Vec2 b{static_cast<double>(x + e.x), static_cast<double>(y + e.y)};
        for (const Cut& cut : cuts)
          if (crosses(cut, a, b)) bonds.words[grid.index(x, y)] &= ~(3u << (2 * d));
      }
  classify_groups(bonds, 0, grid.height - 1);
}

}  // namespace arenite::peridynamics
