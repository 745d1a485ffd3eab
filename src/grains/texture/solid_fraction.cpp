#include "grains/texture/solid_fraction.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/random.hpp"
#include "grains/texture/view.hpp"

namespace arenite::texture {
/// Disk areas cut by the window over the window's area; an overlap counts in both disks. Error from equal blocks.
void solid_fraction(const View& view, Texture& texture) {
  if (!view.has_box) return;
  const Domain& domain = view.packing.domain;
  const Grains& grains = view.packing.grains;
  const BlockGrid blocks{view.blocks.bounds, std::max(2, view.blocks.per_side)};
  std::vector<double> fraction(static_cast<std::size_t>(blocks.count()), 0.0);
  double covered = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double area = covered_area(domain, grains.position[g], grains.radius[g], blocks.bounds);
    covered += area;
    if (area == 0) continue;
    for (int b = 0; b < blocks.count(); ++b) {
      const auto block = blocks.block(b);
      fraction[b] += covered_area(domain, grains.position[g], grains.radius[g], block) / block.area();
    }
  }
  texture.solid_fraction = {covered / blocks.bounds.area(), standard_error(fraction)};
  put(texture.numbers, "solid_fraction", texture.solid_fraction, "",
      "Solid fraction, area of grains over area of the sample");
}

namespace {

/// Solid fractions of windows of the box's shape, `side` of its side long, at random places in the whole box.
std::vector<double> fractions(const Packing& packing, double side, int places, RandomStream random) {
  const Domain& domain = packing.domain;
  const Grains& grains = packing.grains;
  const geometry::Rectangle box = box_of(domain);
  const double width = side * box.width(), height = side * box.height();
  std::vector<double> found;
  for (int p = 0; p < places; ++p) {
    const double x = random.uniform(box.x_min, domain.periodic[0] ? box.x_max : box.x_max - width);
    const double y = random.uniform(box.y_min, domain.periodic[1] ? box.y_max : box.y_max - height);
    const geometry::Rectangle window{x, x + width, y, y + height};
    double covered = 0;
    for (std::size_t g = 0; g < grains.size(); ++g)
      covered += covered_area(domain, grains.position[g], grains.radius[g], window);
    found.push_back(covered / window.area());
  }
  return found;
}

}  // namespace

void rev(const View& view, Texture& texture) {
  if (!view.has_box || view.packing.grains.size() == 0) return;
  texture.rev = growing_windows(
      view.options.rev, 2, view.options.seed, texture.solid_fraction.error,
      [&](double side, int places, RandomStream random) { return fractions(view.packing, side, places, random); });
  texture.numbers["rev"] = numbers_of(texture.rev, "area_share");
}

std::vector<double> window_fractions(const Packing& packing, double area_share, int places, std::uint64_t seed) {
  const geometry::Rectangle box = box_of(packing.domain);
  if (packing.grains.size() == 0 || !(box.area() > 0)) return {};
  return fractions(packing, std::sqrt(area_share), places, RandomStream(seed, Purpose::window, 0));
}

template <int D> std::string note_of_sides_away(const DomainIn<D>& domain) {
  std::string away;
  for (int side = 0; side < sides_in<D>; ++side)
    if (!domain.is_periodic(side) && !domain.wall[side].present)
      away += std::string(away.empty() ? "" : ", ") + any_side_names[side];
  if (away.empty()) return away;
  return "No wall stands on the side " + away +
         ": solid fraction, stress of the assembly and strains are of a box up to its last place.";
}
template std::string note_of_sides_away<2>(const DomainIn<2>&);
template std::string note_of_sides_away<3>(const DomainIn<3>&);

}  // namespace arenite::texture
