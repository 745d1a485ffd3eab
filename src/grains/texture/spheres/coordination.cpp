#include <cstddef>
#include <string>

#include "grains/texture/partners.hpp"
#include "grains/texture/spheres/sphere_view.hpp"

namespace arenite::texture::spheres {

using statistics::Items;
using statistics::put;

SphereStatistic sphere_coordination;

/// As of disks: contacts with walls are not counted.
void sphere_coordination(const SphereView& view, Numbers& to) {
  constexpr const char* mean_number = "Mean number of contacts per grain, of the named pair or set";
  const Partners partners(view.packing, view.rattler);
  Numbers& j = to["coordination"] = Numbers::tree();
  if (view.grains.empty()) return;
  const auto mean_of = [&](const Items& items, auto value) { return statistics::mean(items, view.grain_block, value); };
  put(j, "all", mean_of(view.grains, [&](std::size_t g) { return partners.all(g); }), "", mean_number);
  put(j, "without_rattlers", mean_without_rattlers(view, partners), "", mean_number, Trait::by_forces);
  for (const int x : view.materials())
    for (const int y : view.materials())
      put(j, view.material_name(x) + "-" + view.material_name(y),
          mean_of(view.grains_of(x), [&](std::size_t g) { return partners.with(g, y); }), "", mean_number);
  const std::string sentence =
      "Fraction of grains with fewer than " + std::to_string(view.options.rattler_contacts) + " force-bearing contacts";
  put(j, "rattlers", mean_of(view.grains, [&](std::size_t g) { return view.rattler[g] ? 1.0 : 0.0; }), "",
      sentence.c_str(), Trait::by_forces);
  put(j, "histogram", partners.histogram(view.grains), "", "Fraction of grains with 0, 1, 2, .. contacts",
      Trait::detail);
}

}  // namespace arenite::texture::spheres
