#include <algorithm>

#include "grains/texture/statistics.hpp"

namespace arenite::texture {

/// Disk areas cut by the window over the window's area; an overlap counts in both disks. Error from equal blocks.
void measure_solid_fraction(const View& view, Texture& texture) {
  if (!view.has_box) return;
  const Domain& domain = view.packing.domain;
  const Grains& grains = view.packing.grains;
  const BlockGrid blocks{view.blocks.bounds, std::max(2, view.blocks.per_side)};
  std::vector<double> fraction(static_cast<std::size_t>(blocks.count()), 0.0);
  double covered = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double area = covered_area(domain, grains.centre(g), grains.radius[g], blocks.bounds);
    covered += area;
    if (area == 0) continue;
    for (int b = 0; b < blocks.count(); ++b) {
      const auto block = blocks.block(b);
      fraction[static_cast<std::size_t>(b)] += covered_area(domain, grains.centre(g), grains.radius[g], block) / block.area();
    }
  }
  texture.solid_fraction = {covered / blocks.bounds.area(), standard_error(fraction)};
}

}  // namespace arenite::texture
