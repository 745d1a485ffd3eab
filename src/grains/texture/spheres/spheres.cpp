#include "grains/texture/spheres/spheres.hpp"

#include <cmath>
#include <cstddef>

namespace arenite::texture {

SphereOptions sphere_options(const PackingIn<3>& packing, const Measuring& how) {
  SphereOptions options;
  static_cast<Measuring&>(options) = how;
  const ContactsIn<3>& contacts = packing.contacts;
  constexpr double rounding = 1e-4;  // of the digits of a file
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (norm(contacts.ft[c]) > rounding * std::abs(contacts.fn[c])) options.rattler_contacts = 2;
  return options;
}

SphereOptions sphere_options(const Asked& asked) {
  SphereOptions options;
  if (asked.measure) static_cast<Measuring&>(options) = *asked.measure;
  if (!asked.known) return options;
  if (std::isfinite(asked.load_axis)) options.load_axis = asked.load_axis;
  options.load_direction = {asked.load_direction[0], asked.load_direction[1], asked.load_direction[2]};
  options.gravity = {asked.gravity.x, asked.gravity.y, 0};
  options.pull = static_cast<Pull>(asked.pull);
  options.rattler_contacts = asked.friction > 0 ? 2 : 4;
  return options;
}

Numbers measure_spheres(const PackingIn<3>& packing, const SphereOptions& options) {
  TextureIn<3> texture = measure(packing, options);
  texture.numbers["notes"] = texture.notes;
  return texture.numbers;
}

}  // namespace arenite::texture
