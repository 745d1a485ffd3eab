#include "grains/texture/spheres/spheres.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "grains/texture/spheres/sphere_view.hpp"

namespace arenite::texture {

namespace spheres {

using statistics::described;

// Each in its own file.
SphereStatistic sphere_fraction, sphere_coordination, sphere_fabric, sphere_stress, sphere_forces;

namespace {

void sample(const SphereView& view, Numbers& to) {
  const auto walls = static_cast<std::size_t>(std::ranges::count_if(view.pairs().j, arenite::is_wall));
  to = {{"dimension", described(3, "", "Of space: 3, spheres")},
        {"grains", described(view.packing.grains.size(), "", "Grains of the sample")},
        {"contacts", described(view.pairs().size() - walls, "", "Contacts between grains")},
        {"wall_contacts", described(walls, "", "Contacts with walls")},
        {"considered",
         {{"grains", described(view.grains.size(), "", "Grains in the window of the statistics")},
          {"contacts", described(view.contacts.size(), "", "Contacts in that window")},
          {"border_m", described(view.border, "m", "Strip left out along walls").mark(Trait::detail)}}},
        {"mean_diameter_m", described(view.mean_diameter, "m", "Mean diameter of grains")}};
}

std::vector<std::string> notes_of(const SphereView& view) {
  const bool walled = view.packing.domain.periodic != std::array{true, true, true};
  if (!walled || !(view.options.border > 0) || view.border > 0) return {};
  return {fmt::format("The sample is too small to leave out {:g} mean diameters along its walls, so it is taken whole.",
                      view.options.border)};
}

/// Every statistic that there is, in the order of their numbers.
constexpr SphereStatistic* every_statistic[] = {sample,        sphere_fraction, sphere_coordination,
                                                sphere_fabric, sphere_stress,   sphere_forces};

}  // namespace

}  // namespace spheres

SphereOptions sphere_options(const Asked& asked) {
  SphereOptions options;
  if (asked.measure) static_cast<Measuring&>(options) = *asked.measure;
  if (!asked.known) return options;
  options.gravity = {asked.gravity.x, asked.gravity.y, 0};
  options.rattler_contacts = asked.friction > 0 ? 2 : 4;
  return options;
}

Numbers measure_spheres(const PackingIn<3>& packing, const SphereOptions& options) {
  const spheres::SphereView view(packing, options);
  Numbers numbers;
  for (spheres::SphereStatistic* statistic : spheres::every_statistic) statistic(view, numbers);
  numbers["notes"] = spheres::notes_of(view);
  return numbers;
}

}  // namespace arenite::texture
