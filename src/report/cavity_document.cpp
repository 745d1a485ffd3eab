#include "report/cavity_document.hpp"

#include <cmath>
#include <numbers>

#include "solid/raster/cavities.hpp"
#include "solid/raster/cavity_statistics.hpp"

namespace arenite::report {
namespace {

/// Mean radius of the large grains, or of all without classes, m; 0 where there are no grains.
double mean_large_radius(const PhaseMap& map) {
  std::vector<double> nodes(map.grain_class.size());
  for (const auto g : map.grain)
    if (g >= 0) ++nodes[static_cast<std::size_t>(g)];
  double sum[2] = {}, count[2] = {};
  for (std::size_t g = 0; g < nodes.size(); ++g) {
    if (nodes[g] == 0) continue;
    const std::size_t large = map.grain_class[g] == GrainClass::large;
    sum[large] += std::sqrt(nodes[g] / std::numbers::pi) * map.dx;
    ++count[large];
  }
  if (count[1] > 0) return sum[1] / count[1];
  return count[0] > 0 ? sum[0] / count[0] : 0;
}

Numbers statistics_of(const raster::CavityStatistics& s) {
  return {{"mean", {{"value", s.mean}, {"error", s.mean_error}}}, {"deviation", {{"value", s.deviation}, {"error", s.deviation_error}}},
          {"cv", {{"value", s.cv}, {"error", s.cv_error}}},
          {"edge", s.density.edge}, {"density", s.density.density}, {"error", s.density.error}};
}

raster::CavityRules rules_of(const Numbers& said) {
  raster::CavityRules rules;
  rules.eight_connected = said.value("neighbours", 4) == 8;
  rules.fewest_nodes = said.value("fewest_nodes", rules.fewest_nodes);
  rules.leave_out_border = said.value("leave_out_border", rules.leave_out_border);
  return rules;
}

Numbers kind_of(const PhaseMap& map, raster::Cavity kind, const raster::CavityRules& rules, double radius, const Thinning& kept, NumberBlock& block) {
  const raster::Cavities cavities = raster::find_cavities(map, kind, rules);
  std::vector<std::uint32_t> label(kept.node.size());
  for (std::size_t k = 0; k < label.size(); ++k) label[k] = static_cast<std::uint32_t>(cavities.label[kept.node[k]] + 1);
  Numbers out{{"label", reference(block.add_indices(label))}, {"nodes", reference(block.add_indices(unsigned_copy(cavities.nodes)))},
           {"specks", cavities.specks}, {"cut", cavities.cut}, {"fewest_nodes", cavities.rules.fewest_nodes}};
  if (radius > 0 && !cavities.nodes.empty()) out["volumes"] = statistics_of(raster::cavity_statistics(cavities, map.dx, radius));
  return out;
}

}  // namespace

Numbers cavities_of(const PhaseMap& map, const Numbers& numbers, const Thinning& kept, NumberBlock& block) {
  const Numbers said = numbers.value("cavity_rules", Numbers::tree());
  const raster::CavityRules rules = rules_of(said);
  const double radius = said.contains("reference_radius_m") ? said["reference_radius_m"].get<double>() : mean_large_radius(map);
  return {{"voids", kind_of(map, raster::Cavity::void_, rules, radius, kept, block)},
          {"pores", kind_of(map, raster::Cavity::pore, rules, radius, kept, block)}};
}

}  // namespace arenite::report
