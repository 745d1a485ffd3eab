#include "solid/raster/cavities.hpp"

#include <fmt/format.h>

#include "core/error.hpp"
#include "model/domain.hpp"
#include "solid/raster/components.hpp"

namespace arenite::raster {

Cavities find_cavities(const PhaseMap& map, Cavity kind, const CavityRules& rules) {
  if (rules.fewest_nodes < 0)
    throw InputError(fmt::format("a cavity of at least {} nodes is senseless; give 1 or more", rules.fewest_nodes));
  Components all = find_components(map, kind == Cavity::pore ? Flooded::pores : Flooded::voids, rules.eight_connected);
  Cavities cavities;
  cavities.rules = rules;
  std::vector<std::int32_t> renamed(all.nodes.size(), -1);
  for (std::size_t c = 0; c < all.nodes.size(); ++c) {
    if (rules.leave_out_border && all.sides[c]) {
      ++cavities.cut;
    } else if (all.nodes[c] < rules.fewest_nodes) {
      ++cavities.specks;
    } else {
      renamed[c] = static_cast<std::int32_t>(cavities.nodes.size());
      cavities.nodes.push_back(all.nodes[c]);
    }
  }
  cavities.label = std::move(all.label);
  for (auto& label : cavities.label)
    if (label >= 0) label = renamed[label];
  return cavities;
}

Percolation find_percolation(const PhaseMap& map, bool eight_connected_voids) {
  const auto any = [](const Components& found, int from, int to) {
    const int both = 1 << from | 1 << to;
    for (const auto sides : found.sides)
      if ((sides & both) == both) return true;
    return false;
  };
  const Components voids = find_components(map, Flooded::voids, eight_connected_voids);
  const Components solid = find_components(map, Flooded::solid, !eight_connected_voids);
  return {any(solid, bottom, top), any(solid, left, right), any(voids, bottom, top), any(voids, left, right)};
}

}  // namespace arenite::raster
