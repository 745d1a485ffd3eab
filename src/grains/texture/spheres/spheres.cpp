#include "grains/texture/spheres/spheres.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include "grains/texture/force_scale.hpp"
#include "grains/texture/solid_fraction.hpp"
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
  std::vector<std::string> notes;
  if (!view.has_box)
    notes.push_back(
        "The box is not known, so solid fraction and the stress of the assembly are omitted and no border is left "
        "out.");
  else if (auto note = note_of_sides_away<3>(view.packing.domain); !note.empty()) notes.push_back(std::move(note));
  if (!view.has_forces && view.pairs().size() > 0) notes.emplace_back(forces_not_known);
  if (!view.axis_is_given && view.has_forces)
    notes.push_back(
        "The direction of the load is not given: a_c_signed refers to the sample's own axis of greatest compression.");
  const bool walled = view.has_box && view.packing.domain.periodic != std::array{true, true, true};
  if (walled && view.options.border > 0 && view.border == 0)
    notes.push_back(
        fmt::format("The sample is too small to leave out {:g} mean diameters along its walls, so it is taken whole.",
                    view.options.border));
  return notes;
}

/// Every statistic that there is, in the order of their numbers.
constexpr SphereStatistic* every_statistic[] = {sample,        sphere_fraction, sphere_coordination,
                                                sphere_fabric, sphere_stress,   sphere_forces};

}  // namespace

}  // namespace spheres

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
  options.rattler_contacts = asked.friction > 0 ? 2 : 4;
  return options;
}

Numbers measure_spheres(const PackingIn<3>& packing, const SphereOptions& options) {
  const spheres::SphereView view(packing, options);
  Numbers numbers;
  for (spheres::SphereStatistic* statistic : spheres::every_statistic) statistic(view, numbers);
  if (!view.has_forces && packing.contacts.size() > 0) erase(numbers, Trait::by_forces);
  numbers["notes"] = spheres::notes_of(view);
  return numbers;
}

}  // namespace arenite::texture
