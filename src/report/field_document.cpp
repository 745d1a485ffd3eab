#include "report/field_document.hpp"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "model/field_quantities.hpp"
#include "model/kinds.hpp"
#include "report/colour_ends.hpp"
#include "report/figures/field_figures.hpp"
#include "report/figures/headlines.hpp"
#include "report/packing_layers.hpp"
#include "report/page_document.hpp"
#include "solid/grid/cavities.hpp"
#include "solid/grid/cavity_statistics.hpp"
#include "solid/grid/map_numbers.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/sample_means.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::report {
namespace {

/// Labels from 1 on of the nodes that are drawn; 0 where there is none (-1 in the map).
template <class T> std::vector<std::uint32_t> labels_of(const std::vector<T>& label, const Thinning& kept) {
  return mapped(kept.node, [&](std::size_t node) { return static_cast<std::uint32_t>(label[node] + 1); });
}

/// "voids" and "pores" of a map: label of every node on the page (0: none) and nodes of each, by the rules that the
/// result's numbers state, which have their volumes too; without these by the rules' defaults.
Numbers cavities_of(const PhaseMap& map, const Numbers& numbers, const Thinning& kept, NumberBlock& block) {
  const Numbers said = numbers.value("cavity_rules", Numbers::tree());
  grid::CavityRules rules;
  rules.eight_connected = said.value("neighbours", 4) == 8;
  rules.fewest_nodes = said.value("fewest_nodes", rules.fewest_nodes);
  rules.leave_out_border = said.value("leave_out_border", rules.leave_out_border);
  Numbers all = Numbers::tree();
  for (const auto& [name, kind] : {std::pair{"voids", grid::Cavity::void_}, {"pores", grid::Cavity::pore}}) {
    const grid::Cavities cavities = grid::find_cavities(map, kind, rules);
    all[name] = {{"label", block.add_indices(labels_of(cavities.label, kept))},
                 {"nodes", block.add_indices(cavities.nodes)},
                 {"specks", cavities.specks},
                 {"cut", cavities.cut},
                 {"fewest_nodes", cavities.rules.fewest_nodes}};
  }
  return all;
}

bool same_map(const PhaseMap& a, const PhaseMap& b) {
  return a.width == b.width && a.height == b.height && a.dx == b.dx && a.phase == b.phase && a.grain == b.grain &&
         a.grain_class == b.grain_class;
}

Numbers map_of(const PhaseMap& map, const Numbers& numbers, const Thinning& kept, NumberBlock& block) {
  return {{"width", kept.width},
          {"height", kept.height},
          {"stride", kept.stride},
          {"dx", map.dx},
          {"full", {map.width, map.height}},
          {"kind", block.add_indices(kept.of(kinds_of(map)))},
          {"label", block.add_indices(labels_of(map.grain, kept))},
          {"grain_kind", block.add_indices(mapped(map.grain_class, [](GrainClass of) { return kind_of(of); }))},
          {"fractions", mapped(grid::fractions_by_kind(map), std::identity{})},
          {"cavities", cavities_of(map, numbers, kept, block)}};
}

/// One component on the page's nodes, with its mean, and extremes over all nodes of the map that are not void.
Numbers component(const PhaseMap& map, const Thinning& kept, const std::vector<std::uint8_t>& solid,
                  const std::vector<double>& values, bool companded, NumberBlock& block) {
  std::vector<double> inside;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (map.phase[k] != Phase::empty) inside.push_back(values[k]);
  const auto [least, most] = inside.empty() ? std::ranges::min_max_result<double>{0, 0} : std::ranges::minmax(inside);
  Numbers out = numbers_of(code_field(kept.width, kept.height, kept.of(values), solid, companded), block);
  out.update(Numbers{{"least", least}, {"most", most}});
  return out;
}

/// Those that are stored; the page forms the others by the formulas of `quantities_of`.
Numbers components_of(const FieldResult& result, const stress::SampleMeans& means, const Thinning& kept,
                      NumberBlock& block) {
  const auto solid =
      mapped<std::uint8_t>(kept.node, [&](std::size_t node) { return result.map.phase[node] != Phase::empty; });
  Numbers all = Numbers::tree();
  for (const FieldQuantity& quantity : field_quantities()) {
    if (!quantity.is_stored()) continue;
    const std::vector<double> values = values_of(quantity, result.field);
    if (values.size() != result.map.size()) continue;
    const bool is_stress = quantity.unit == "Pa";  // which has tails; displacements have none
    Numbers& one = all[std::string(quantity.name)];
    one = component(result.map, kept, solid, values, is_stress, block);
    one["mean"] = means.of(quantity);
    one["unit"] = std::string(quantity.unit);
  }
  return all;
}

/// What the page may paint or tell of nodes and grains, in its order, with its mean and the ends of its colours.
Numbers quantities_of(const FieldResult& result, const stress::SampleMeans& means) {
  Numbers all = Numbers::tree();
  if (result.field.size() == 0) return all;
  for (const FieldQuantity& q : field_quantities()) {
    Numbers& one = all[std::string(q.id)];
    one = {{"name", std::string(q.name)},       {"symbol", std::string(q.symbol)}, {"unit", std::string(q.unit)},
           {"formula", std::string(q.formula)}, {"offered", q.is_offered},         {"magnitude", q.is_magnitude}};
    if (!q.is_offered || !has(result.field, q)) continue;
    one["mean"] = means.of(q);
    std::vector<double> values = values_of(q, result.field);
    for (std::size_t k = 0; k < values.size(); ++k)
      if (result.map.phase[k] == Phase::empty) values[k] = statistics::unknown;
    one["ends"] = numbers_of(ends_of(std::move(values), nodes_beyond));
  }
  return all;
}

/// How a stress is told against the mean of the sample, and what "strong" is measured by, Pa.
void add_comparison(Numbers& out, const stress::SampleMeans& means) {
  out["relative"] = {{"symbol", std::string(relative_stress.symbol)},
                     {"formula", std::string(relative_stress.formula)}};
  out["scale"] = means.scale();
  if (const FieldQuantity* by = means.strongest()) out["acts_by"] = std::string(by->id);
}

/// Nodes, radii of disks of the same area, centres, mean stresses and extremes of all grains; no stresses without a
/// field.
Numbers grains_of(const stress::GrainStresses& g, const FieldResult& result, NumberBlock& block) {
  const auto column = [&](const auto& rows, auto member, const char* unit) {
    return block.add_reals(mapped(rows, member), unit);
  };
  const auto radius = [&](auto nodes) { return grid::radius_over(static_cast<double>(nodes)) * result.map.dx; };
  Numbers out{{"nodes", block.add_indices(g.nodes)},
              {"radius", block.add_reals(mapped(g.nodes, radius), "m")},
              {"x", column(g.centre, &Vec2::x, "m")},
              {"y", column(g.centre, &Vec2::y, "m")}};
  if (result.field.size() == 0) return out;
  const auto [least, most] = stress::extremes_of(result.map, result.field);
  out.update({{"xx", column(g.stress, &Tensor2::xx, "Pa")},
              {"yy", column(g.stress, &Tensor2::yy, "Pa")},
              {"xy", column(g.stress, &Tensor2::xy, "Pa")},
              {"yy_least", block.add_reals(least, "Pa")},
              {"yy_most", block.add_reals(most, "Pa")}});
  return out;
}

Numbers cracks_of(const std::vector<Crack>& cracks, NumberBlock& block) {
  return {{"count", cracks.size()},
          {"x", block.add_reals(mapped<double>(cracks, &Crack::x), "m")},
          {"y", block.add_reals(mapped<double>(cracks, &Crack::y), "m")},
          {"type", block.add_indices(mapped(cracks, &Crack::type))},
          {"strain", block.add_reals(mapped(cracks, &Crack::strain))}};
}

/// The densities that the page draws, and grains; of densities only notes where there is nothing to measure.
std::pair<Numbers, stress::GrainStresses> measured(const FieldResult& result) {
  const stress::StressOptions options = stress::options_of(result);
  Numbers notes = Numbers::tree();
  try {
    if (result.field.size() > 0) {
      auto statistics = stress::measure(result.map, result.field, options);
      return {stress::numbers(statistics, true), std::move(statistics.grains)};
    }
  } catch (const InputError& error) {
    notes["notes"] = Numbers::list({error.what()});
  }  // a sample without any stress has a page too
  return {std::move(notes), stress::measure_grains(result.map, result.field, options.clamp_rows, options.blocks)};
}

Numbers field_of(const FieldResult& r, const stress::Statistics* known, std::size_t map, const Thinning& kept,
                 NumberBlock& block, const figures::WriteList& write) {
  const auto [densities, grains] = known ? std::pair(stress::numbers(*known, true), known->grains) : measured(r);
  const stress::SampleMeans means(r);
  Numbers out{{"name", r.name},
              {"converged", r.converged},
              {"outcome", r.outcome},
              {"provenance", provenance_of(r.provenance)},
              {"map", map},
              {"quantities", quantities_of(r, means)},
              {"components", components_of(r, means, kept, block)},
              {"grains", grains_of(grains, r, block)},
              {"curve", history_of(r.curve, block)},
              {"headlines", figures::numbers_of(figures::headlines_of(r))},
              {"figures", shortened(figures::numbers_of(figures::field_figures(), {r, densities}, write, true))}};
  add_comparison(out, means);
  add_numbers(out, r.numbers);
  if (!r.cracks.empty()) out["cracks"] = cracks_of(r.cracks, block);
  return out;
}

}  // namespace

Thinning::Thinning(const PhaseMap& map, std::size_t most) {
  const auto left = [](int nodes, int by) { return std::max(1, nodes / by); };
  while (static_cast<std::size_t>(left(map.width, stride)) * static_cast<std::size_t>(left(map.height, stride)) > most)
    ++stride;
  width = map.width > 0 ? left(map.width, stride) : 0;
  height = map.height > 0 ? left(map.height, stride) : 0;
  const int first = stride / 2;
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      node.push_back(
          map.index(std::min(map.width - 1, first + x * stride), std::min(map.height - 1, first + y * stride)));
}

Numbers densities_of(const FieldResult& result) { return measured(result).first; }

void add_fields(Numbers& document, const PageData& data, NumberBlock& block, const figures::WriteList& write) {
  std::vector<const PhaseMap*> known;
  Numbers maps = Numbers::list(), list = Numbers::list();
  for (std::size_t f = 0; f < data.fields.size(); ++f) {
    const FieldResult& result = data.fields[f];
    const PhaseMap& map = result.map;
    const Thinning kept(map);
    const auto at =
        std::find_if(known.begin(), known.end(), [&](const PhaseMap* other) { return same_map(*other, map); });
    const auto place = static_cast<std::size_t>(at - known.begin());
    if (at == known.end()) {
      known.push_back(&map);
      maps.push_back(map_of(map, shortened(result.numbers), kept, block));
    }
    list.push_back(
        field_of(result, known_of(data.measured, &workflow::KnownStatistics::fields, f), place, kept, block, write));
  }
  document["maps"] = std::move(maps);
  document["fields"] = std::move(list);
}

}  // namespace arenite::report
