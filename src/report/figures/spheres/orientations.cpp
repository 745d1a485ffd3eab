#include "report/figures/spheres/orientations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "grains/texture/spheres/hemisphere.hpp"
#include "report/figures/roses.hpp"
#include "statistics/sectors.hpp"

namespace arenite::report::figures {
namespace {

namespace hemisphere = texture::spheres::hemisphere;

constexpr double degrees = 180 / std::numbers::pi;

Hemisphere hemisphere_of(std::string name, const Numbers& set) {
  Hemisphere shown{.name = std::move(name), .count = estimate_at(set, "/contacts").value};
  shown.values = statistics::over_isotropic(reals_at(set, "/directions"), shown.count);
  shown.words = anisotropy_in_words(set);
  const std::vector<double> axis = reals_at(set, "/axis");
  if (axis.size() == 3 && estimate_at(set, "/a_c").value > estimate_at(set, "/a_c_noise").value) {
    const auto [radius, angle] = hemisphere::projected({axis[0], axis[1], axis[2]});
    shown.mark = {radius * std::cos(angle), radius * std::sin(angle)};
  }
  return shown;
}

}  // namespace

Drawings orientations_in_space(const Numbers& texture) {
  const Numbers* all = texture.at_path("/fabric");
  if (!all || !all->contains("directions")) return {};
  Hemispheres shown{.sets = {hemisphere_of("all", *all)}, .reach = 0, .measure = "over isotropic"};
  for (const char* name : {"strong", "weak"})
    if (const Numbers* set = all->at_path(std::string("/sets/") + name))
      shown.sets.push_back(hemisphere_of(name, *set));
  for (const Hemisphere& one : shown.sets) shown.reach = std::max(shown.reach, largest_of(one.values, 0));
  for (const auto& [inner, outer, from, to] : hemisphere::every_cell()) {
    shown.inner.push_back(inner), shown.outer.push_back(outer);
    shown.from.push_back(degrees * from), shown.to.push_back(degrees * to);
  }
  return {{.hemispheres = shown}};
}

}  // namespace arenite::report::figures
