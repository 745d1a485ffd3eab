#include "report/figures/spheres/orientations.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "grains/texture/spheres/hemisphere.hpp"
#include "report/figures/roses.hpp"

namespace arenite::report::figures {
namespace {

namespace hemisphere = texture::spheres::hemisphere;

constexpr double degrees = 180 / std::numbers::pi;

/// Of `whole` contacts without a preferred direction each cell would have as many.
Hemisphere hemisphere_of(std::string name, const Numbers& set) {
  Hemisphere shown{.name = std::move(name), .count = estimate_at(set, "/contacts").value};
  shown.values = scaled(reals_at(set, "/directions"), hemisphere::cells / shown.count);
  for (const auto& cell : hemisphere::every_cell()) {
    shown.inner.push_back(cell.inner), shown.outer.push_back(cell.outer);
    shown.from.push_back(degrees * cell.from), shown.to.push_back(degrees * cell.to);
  }
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
  Drawing drawing{.hemispheres = {hemisphere_of("all", *all)}};
  for (const char* name : {"strong", "weak"})
    if (const Numbers* set = all->at_path(std::string("/sets/") + name))
      drawing.hemispheres.push_back(hemisphere_of(name, *set));
  double reach = 0;
  for (const Hemisphere& one : drawing.hemispheres) reach = std::max(reach, largest_of(one.values, 0));
  for (Hemisphere& one : drawing.hemispheres) one.reach = reach;
  return {drawing};
}

}  // namespace arenite::report::figures
