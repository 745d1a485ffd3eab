#include "grains/texture/mass.hpp"

#include <numbers>

namespace arenite::texture {

double mass_of(const Packing& packing, std::size_t g) {
  const double r = packing.grains.radius[g];
  const double density = packing.materials.at(packing.grains.material[g]).density;
  return density * std::numbers::pi * r * r * packing.domain.thickness;
}

double mass_of(const PackingIn<3>& packing, std::size_t g) {
  const double r = packing.grains.radius[g];
  const double density = packing.materials.at(packing.grains.material[g]).density;
  return density * (4.0 / 3.0 * std::numbers::pi * r * r * r);
}

double mass_of(const Packing& packing) {
  double mass = 0;
  for (std::size_t g = 0; g < packing.grains.size(); ++g) mass += mass_of(packing, g);
  return mass;
}

}  // namespace arenite::texture
