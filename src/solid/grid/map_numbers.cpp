#include "solid/grid/map_numbers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "solid/grid/cavities.hpp"
#include "solid/grid/cavity_statistics.hpp"
#include "solid/grid/rasterise_spheres.hpp"

namespace arenite::grid {

double radius_over(double nodes) { return std::sqrt(nodes / std::numbers::pi); }

namespace {

using statistics::described;

/// Volumes of pores or voids over pi radius^2 with their density, and what the rules left out.
Numbers volumes(const PhaseMap& map, Cavity kind, const CavityRules& rules, double radius) {
  const auto s = cavity_statistics(find_cavities(map, kind, rules), map.dx, radius);
  Numbers j{
      {"count", described(s.count, "",
                          kind == Cavity::pore ? "Spaces between grains, with or without matrix" : "Empty spaces")}};
  if (s.count > 0) j["mean"] = described(s.mean, "", "Mean volume over pi times the reference radius squared");
  if (s.count > 1) {
    j["deviation"] = described(s.deviation, "", "Standard deviation of these volumes");
    j["cv"] = described(s.cv, "", "Their standard deviation over their mean");
    if (s.peak > 0) j["peak"] = described(s.peak, "", "Volume at the maximum of their density");
    j["tenth"] = described(s.tenth, "", "Volume below which a tenth of them lies");
    j["median"] = described(s.median, "", "Median of these volumes");
    j["pdf"] = {{"edge", s.density.edge}, {"density", s.density.density}, {"error", s.density.error}};
  }
  j["specks"] = described(s.specks, "", "Sets with too few nodes");
  j["at_border"] = described(s.cut, "", "Left out because they reach the border");
  return j;
}

bool has_classes(const PhaseMap& map) {
  return std::any_of(map.grain_class.begin(), map.grain_class.end(),
                     [](GrainClass c) { return c != GrainClass::none; });
}

Numbers phases(const PhaseMap& map) {
  const auto f = phase_fractions(map);
  Numbers j{{"particle", f.particle}, {"matrix", f.matrix}, {"void", f.empty}};
  if (has_classes(map)) {
    j.update({{"large", f.large}, {"small", f.small}});
    if (f.unclassed > 0) j["unclassed"] = f.unclassed;
  }
  return described(std::move(j), "", "Fraction of the nodes");
}

Numbers grains(const PhaseMap& map) {
  const auto of = [&](GrainClass one) {
    return static_cast<std::size_t>(std::count(map.grain_class.begin(), map.grain_class.end(), one));
  };
  Numbers j{{"all", map.grain_class.size()}};
  if (has_classes(map)) j.update({{"large", of(GrainClass::large)}, {"small", of(GrainClass::small)}});
  return described(std::move(j), "", "Grains of the map");
}

}  // namespace

Numbers map_numbers(const PhaseMap& map, const CavityRules& rules, double reference_radius) {
  Numbers j;
  j["map"] = {{"width", described(map.width, "", "Nodes along x")},
              {"height", described(map.height, "", "Nodes along y")},
              {"dx_m", described(map.dx, "m", "Node spacing")}};
  j["grains"] = grains(map);
  j["phases"] = phases(map);
  const auto fractions = phase_fractions(map);
  j["solid_fraction"] = described(fractions.particle, "", "Solid fraction: fraction of the nodes in grains");
  j["S_m"] = described(fractions.saturation, "",
                       "Saturation S_m: fraction of the space between grains filled by matrix, by nodes");
  if (fractions.small > 0)
    j["volume_ratio"] = described(fractions.large / fractions.small, "", "Area of large over area of small grains");
  const auto through = find_percolation(map, rules.eight_connected);
  j["percolates"] = described({{"solid_bottom_top", through.solid_bottom_top},
                               {"solid_left_right", through.solid_left_right},
                               {"void_bottom_top", through.void_bottom_top},
                               {"void_left_right", through.void_left_right}},
                              "", "Whether solid or void connects these two sides");
  j["cavity_rules"] = {
      {"neighbours", rules.eight_connected ? 8 : 4},
      {"fewest_nodes", rules.fewest_nodes},
      {"leave_out_border", rules.leave_out_border},
      {"reference_radius_m", described(reference_radius, "m", "Reference radius of the volumes of pores and voids")}};
  j["pores"] = volumes(map, Cavity::pore, rules, reference_radius);
  j["voids"] = volumes(map, Cavity::void_, rules, reference_radius);
  return j;
}

Numbers map_numbers(const VoxelMap& map) {
  std::array<double, 3> count{};
  for (const Phase phase : map.phase) count[static_cast<std::size_t>(phase)] += 1;
  const auto share = [&](Phase phase) {
    return count[static_cast<std::size_t>(phase)] / static_cast<double>(map.size());
  };
  Numbers j{{"voxels", described({map.width, map.height, map.depth}, "", "Voxels along x, y and z")}};
  if (map.has_length) j["dx_m"] = described(map.dx, "m", "Side of a voxel");
  else j["lengths"] = "in voxels, since dx was not given";
  j["phases"] = {{"void", described(share(Phase::empty), "", "Fraction of the volume that is void")},
                 {"matrix", described(share(Phase::matrix), "", "Fraction of the volume in matrix")},
                 {"particle", described(share(Phase::particle), "", "Fraction of the volume in grains")}};
  j["saturation"] = described(saturation_of(map), "", "S_m, matrix over what is not grain");
  j["grains"] = described(map.grain_class.size(), "", "Grains");
  return j;
}

}  // namespace arenite::grid
