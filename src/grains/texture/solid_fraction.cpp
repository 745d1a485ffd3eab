#include "grains/texture/solid_fraction.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "geometry/ball.hpp"
#include "grains/texture/view.hpp"

namespace arenite::texture {
namespace {

const char* what_it_is(const Domain& /*domain*/) { return "Solid fraction, area of grains over area of the sample"; }
const char* what_it_is(const DomainIn<3>& /*domain*/) {
  return "Solid fraction, volume of grains over volume of the sample";
}

}  // namespace

/// Areas of disks, volumes of spheres, cut by the window over the window's; an overlap counts in both grains. Error
/// from equal blocks.
template <int D> void solid_fraction(const ViewIn<D>& view, TextureIn<D>& texture) {
  if (!view.has_box) return;
  const DomainIn<D>& domain = view.packing.domain;
  const GrainsIn<D>& grains = view.packing.grains;
  const BlockGridIn<D> blocks{view.blocks.bounds, std::max(2, view.blocks.per_side)};
  std::vector<double> fraction(static_cast<std::size_t>(blocks.count()), 0.0);
  double covered = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    const double part = covered_by<D>(domain, grains.position[g], grains.radius[g], blocks.bounds);
    covered += part;
    if (part == 0) continue;
    for (int b = 0; b < blocks.count(); ++b) {
      const Region<D> block = blocks.block(b);
      fraction[static_cast<std::size_t>(b)] +=
          covered_by<D>(domain, grains.position[g], grains.radius[g], block) / volume_of(block);
    }
  }
  texture.solid_fraction = {covered / volume_of(blocks.bounds), standard_error(fraction)};
  put(texture.numbers, "solid_fraction", texture.solid_fraction, "", what_it_is(domain));
}
template void solid_fraction(const View&, Texture&);
template void solid_fraction(const SphereView&, TextureIn<3>&);

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
