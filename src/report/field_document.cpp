#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "report/page_document.hpp"
#include "solid/grid/cavities.hpp"
#include "solid/stress/stress.hpp"

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

Numbers volumes_of(const grid::CavityStatistics& s) {
  return {{"mean", s.mean}, {"deviation", s.deviation}, {"cv", s.cv}, {"edge", s.density.edge}, {"density", s.density.density}, {"error", s.density.error}};
}

/// Labels from 1 on of the nodes that are drawn; 0 where there is none (-1 in the map).
template <class T> std::vector<std::uint32_t> labels_of(const std::vector<T>& label, const Thinning& kept) {
  return mapped(kept.node, [&](std::size_t node) { return static_cast<std::uint32_t>(label[node] + 1); });
}

/// "voids" and "pores" of a map: label of every node on the page (0: none), nodes of each, and the density of their
/// volumes, by the rules and over the reference radius that the result's numbers state; without these by the rules'
/// defaults, over the mean radius of the large grains (of any where there are no classes).
Numbers cavities_of(const PhaseMap& map, const Numbers& numbers, const Thinning& kept, NumberBlock& block) {
  const Numbers said = numbers.value("cavity_rules", Numbers::tree());
  grid::CavityRules rules;
  rules.eight_connected = said.value("neighbours", 4) == 8;
  rules.fewest_nodes = said.value("fewest_nodes", rules.fewest_nodes);
  rules.leave_out_border = said.value("leave_out_border", rules.leave_out_border);
  const double radius = said.contains("reference_radius_m") ? said["reference_radius_m"].get<double>() : mean_large_radius(map);
  Numbers all = Numbers::tree();
  for (const auto& [name, kind] : {std::pair{"voids", grid::Cavity::void_}, {"pores", grid::Cavity::pore}}) {
    const grid::Cavities cavities = grid::find_cavities(map, kind, rules);
    Numbers& out = all[name];
    out = {{"label", block.add_indices(labels_of(cavities.label, kept))},
           {"nodes", block.add_indices(unsigned_copy(cavities.nodes))},
           {"specks", cavities.specks},
           {"cut", cavities.cut},
           {"fewest_nodes", cavities.rules.fewest_nodes}};
    if (radius > 0 && !cavities.nodes.empty()) out["volumes"] = volumes_of(grid::cavity_statistics(cavities, map.dx, radius));
  }
  return all;
}

bool same_map(const PhaseMap& a, const PhaseMap& b) {
  return a.width == b.width && a.height == b.height && a.dx == b.dx && a.phase == b.phase && a.grain == b.grain && a.grain_class == b.grain_class;
}

Numbers map_of(const PhaseMap& map, const Numbers& numbers, const Thinning& kept, NumberBlock& block) {
  std::array<std::size_t, 3> nodes{};
  for (const Phase phase : map.phase) ++nodes[static_cast<std::size_t>(phase)];
  return {{"width", kept.width},
          {"height", kept.height},
          {"stride", kept.stride},
          {"dx", map.dx},
          {"full", {map.width, map.height}},
          {"nodes", {nodes[0], nodes[1], nodes[2]}},
          {"phase", block.add_indices(unsigned_copy(kept.of(map.phase)))},
          {"label", block.add_indices(labels_of(map.grain, kept))},
          {"grain_class", block.add_indices(unsigned_copy(map.grain_class))},
          {"cavities", cavities_of(map, numbers, kept, block)}};
}

/// One component on the page's nodes, with mean and extremes over all nodes of the map that are not void.
Numbers component(const PhaseMap& map, const Thinning& kept, const std::vector<std::uint8_t>& solid, const std::vector<double>& values, bool companded,
                  NumberBlock& block) {
  double sum = 0, least = INFINITY, most = -INFINITY;
  std::size_t count = 0;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (map.phase[k] == Phase::empty) continue;
    sum += values[k];
    least = std::min(least, values[k]);
    most = std::max(most, values[k]);
    ++count;
  }
  if (count == 0) least = most = 0;
  Numbers out = numbers_of(code_field(kept.width, kept.height, kept.of(values), solid, companded), block);
  out.update(Numbers{{"mean", count ? sum / static_cast<double>(count) : 0}, {"least", least}, {"most", most}});
  return out;
}

Numbers components_of(const FieldResult& result, const Thinning& kept, NumberBlock& block) {
  const StressField& f = result.field;
  const auto solid = mapped<std::uint8_t>(kept.node, [&](std::size_t node) { return result.map.phase[node] != Phase::empty; });
  Numbers all = Numbers::tree();
  const auto add = [&](const char* name, const std::vector<double>& values, bool companded) {
    if (values.size() == result.map.size()) all[name] = component(result.map, kept, solid, values, companded, block);
  };
  add("yy", f.yy, true);
  add("xx", f.xx, true);
  add("xy", f.xy, true);
  add("ux", f.ux, false);
  add("uy", f.uy, false);
  return all;
}

/// Nodes, centres and mean stresses of all grains; no stresses without a field.
Numbers grains_of(const FieldResult& result, NumberBlock& block) {
  const stress::StressOptions usual;
  const stress::GrainStresses g = stress::measure_grains(result.map, result.field, usual.clamp_rows, usual.blocks);
  const auto column = [&](const auto& rows, auto member) { return block.add_reals(mapped(rows, member)); };
  Numbers out{{"nodes", block.add_indices(unsigned_copy(g.nodes))}, {"x", column(g.centre, &Vec2::x)}, {"y", column(g.centre, &Vec2::y)}};
  if (result.field.size() > 0)
    out.update(Numbers{{"xx", column(g.stress, &Tensor2::xx)}, {"yy", column(g.stress, &Tensor2::yy)}, {"xy", column(g.stress, &Tensor2::xy)}});
  return out;
}

Numbers cracks_of(const std::vector<Crack>& cracks, NumberBlock& block) {
  const auto reals = [&](auto member) { return block.add_reals(mapped<double>(cracks, member)); };
  Numbers x = reals(&Crack::x), y = reals(&Crack::y), type = block.add_indices(mapped<std::uint32_t>(cracks, &Crack::type));
  return {{"count", cracks.size()}, {"x", x}, {"y", y}, {"type", type}, {"strain", reals(&Crack::strain)}};
}

/// Those that the stored statistics of stress were measured with, for all components.
stress::StressOptions options_of(const FieldResult& field) {
  stress::StressOptions options;
  options.components = {stress::Component::yy, stress::Component::xx, stress::Component::xy, stress::Component::hydrostatic};
  const Numbers* said = field.numbers.at_path("/stress/options");
  if (!said) return options;
  options.clamp_rows = said->value("clamp_rows", options.clamp_rows);
  options.leave_out_surface = said->value("leave_out_surface", options.leave_out_surface);
  options.leave_out_unloaded = said->value("leave_out_unloaded", options.leave_out_unloaded);
  options.mean_over_area = said->value("sample_mean_over", std::string()) == "area";
  options.blocks = said->value("blocks", options.blocks);
  return options;
}

/// The densities that the page draws; empty where there is nothing to measure.
Numbers statistics_of(const FieldResult& result) {
  if (result.field.size() == 0) return Numbers::tree();
  try {
    return shortened(stress::numbers(stress::measure(result.map, result.field, options_of(result)), true));
  } catch (const InputError& error) {
    return {{"notes", {error.what()}}};  // a sample without any stress has a page too
  }
}

Numbers field_of(const FieldResult& r, std::size_t map, const Thinning& kept, NumberBlock& block) {
  Numbers out{{"name", r.name},
              {"converged", r.converged},
              {"outcome", r.outcome},
              {"provenance", provenance_of(r.provenance)},
              {"map", map},
              {"components", components_of(r, kept, block)},
              {"grains", grains_of(r, block)},
              {"convergence", history_of(r.convergence, block)},
              {"curve", history_of(r.curve, block)},
              {"numbers", shortened(r.numbers)},
              {"statistics", statistics_of(r)}};
  out["statistics"].erase("grains");
  if (!r.cracks.empty()) out["cracks"] = cracks_of(r.cracks, block);
  return out;
}

}  // namespace

Thinning::Thinning(const PhaseMap& map, std::size_t most) {
  const auto left = [](int nodes, int by) { return std::max(1, nodes / by); };
  while (static_cast<std::size_t>(left(map.width, stride)) * static_cast<std::size_t>(left(map.height, stride)) > most) ++stride;
  width = map.width > 0 ? left(map.width, stride) : 0;
  height = map.height > 0 ? left(map.height, stride) : 0;
  const int first = stride / 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x) node.push_back(map.index(std::min(map.width - 1, first + x * stride), std::min(map.height - 1, first + y * stride)));
}

void add_fields(Numbers& document, std::span<const FieldResult> fields, NumberBlock& block) {
  std::vector<const PhaseMap*> known;
  Numbers maps = Numbers::list(), list = Numbers::list();
  for (const FieldResult& result : fields) {
    const PhaseMap& map = result.map;
    const Thinning kept(map);
    const auto at = std::find_if(known.begin(), known.end(), [&](const PhaseMap* other) { return same_map(*other, map); });
    const auto place = static_cast<std::size_t>(at - known.begin());
    if (at == known.end()) {
      known.push_back(&map);
      maps.push_back(map_of(map, shortened(result.numbers), kept, block));
    }
    list.push_back(field_of(result, place, kept, block));
  }
  document["maps"] = std::move(maps);
  document["fields"] = std::move(list);
}

}  // namespace arenite::report
