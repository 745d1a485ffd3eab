#include "report/field_document.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.hpp"
#include "report/cavity_document.hpp"
#include "report/field_codes.hpp"
#include "report/grain_means.hpp"
#include "report/thinned_map.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::report {
namespace {

bool same_map(const PhaseMap& a, const PhaseMap& b) {
  return a.width == b.width && a.height == b.height && a.dx == b.dx && a.phase == b.phase && a.grain == b.grain &&
         a.grain_class == b.grain_class;
}

Numbers map_of(const PhaseMap& map, const Numbers& numbers, const Thinning& kept, NumberBlock& block) {
  std::vector<std::uint32_t> label(kept.node.size());
  for (std::size_t k = 0; k < label.size(); ++k) label[k] = static_cast<std::uint32_t>(map.grain[kept.node[k]] + 1);
  std::array<std::size_t, 3> nodes{};
  for (const Phase phase : map.phase) ++nodes[static_cast<std::size_t>(phase)];
  return {{"width", kept.width}, {"height", kept.height}, {"stride", kept.stride}, {"dx", map.dx},
          {"full", {map.width, map.height}}, {"nodes", {nodes[0], nodes[1], nodes[2]}},
          {"phase", reference(block.add_indices(unsigned_copy(kept.of(map.phase))))},
          {"label", reference(block.add_indices(label))},
          {"grain_class", reference(block.add_indices(unsigned_copy(map.grain_class)))},
          {"cavities", cavities_of(map, numbers, kept, block)}};
}

/// One component on the page's nodes, with mean and extremes over all nodes of the map that are not void.
Numbers component(const PhaseMap& map, const Thinning& kept, const std::vector<std::uint8_t>& solid,
               const std::vector<double>& values, bool companded, NumberBlock& block) {
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
  const CodedField coded = code_field(kept.width, kept.height, kept.of(values), solid, companded);
  const Coding& c = coded.coding;
  return {{"law", companded ? "sinh" : "linear"}, {"centre", c.centre}, {"width", c.width}, {"levels", c.levels},
          {"residual", reference(block.add_indices(coded.residual))},
          {"mean", count ? sum / static_cast<double>(count) : 0}, {"least", least}, {"most", most}};
}

Numbers components_of(const FieldResult& result, const Thinning& kept, NumberBlock& block) {
  const StressField& f = result.field;
  std::vector<std::uint8_t> solid(kept.node.size());
  for (std::size_t k = 0; k < solid.size(); ++k) solid[k] = result.map.phase[kept.node[k]] != Phase::empty;
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

Numbers grains_of(const GrainMeans& g, NumberBlock& block) {
  const auto reals = [&](const std::vector<double>& values) { return reference(block.add_reals(values)); };
  Numbers out{{"nodes", reference(block.add_indices(g.nodes))}, {"x", reals(g.x)}, {"y", reals(g.y)}};
  if (!g.yy.empty()) out.update(Numbers{{"xx", reals(g.xx)}, {"yy", reals(g.yy)}, {"xy", reals(g.xy)}});
  return out;
}

Numbers cracks_of(const std::vector<Crack>& cracks, NumberBlock& block) {
  std::vector<double> x, y, strain;
  std::vector<std::uint32_t> type;
  for (const Crack& crack : cracks) {
    x.push_back(static_cast<double>(crack.x));
    y.push_back(static_cast<double>(crack.y));
    strain.push_back(crack.strain);
    type.push_back(crack.type);
  }
  return {{"count", cracks.size()}, {"x", reference(block.add_reals(x))}, {"y", reference(block.add_reals(y))},
          {"type", reference(block.add_indices(type))}, {"strain", reference(block.add_reals(strain))}};
}

Numbers shortened(Numbers numbers) {
  if (!numbers.is_known()) return Numbers::tree();
  shorten(numbers);
  return numbers;
}

/// The densities that the page draws; empty where there is nothing to measure.
Numbers statistics_of(const FieldPageData& data) {
  if (data.result->field.size() == 0) return Numbers::tree();
  stress::StressOptions options = data.statistics;
  options.components = {stress::Component::yy, stress::Component::xx, stress::Component::xy, stress::Component::hydrostatic};
  try {
    return shortened(stress::numbers(stress::measure(data.result->map, data.result->field, options), true));
  } catch (const InputError& error) {
    return {{"notes", {error.what()}}};  // a sample without any stress has a page too
  }
}

Numbers field_of(const FieldPageData& data, std::size_t map, const Thinning& kept, NumberBlock& block) {
  const FieldResult& r = *data.result;
  Numbers out{{"name", r.name}, {"converged", r.converged}, {"outcome", r.outcome}, {"provenance", provenance_of(r.provenance)},
           {"map", map}, {"components", components_of(r, kept, block)},
           {"grains", grains_of(grain_means(r.map, r.field), block)},
           {"convergence", history_of(r.convergence, block)}, {"curve", history_of(r.curve, block)},
           {"numbers", shortened(r.numbers)}, {"statistics", statistics_of(data)}};
  out["statistics"].erase("grains");
  if (!r.cracks.empty()) out["cracks"] = cracks_of(r.cracks, block);
  return out;
}

}  // namespace

void add_fields(Numbers& document, const std::vector<FieldPageData>& fields, NumberBlock& block) {
  std::vector<const PhaseMap*> known;
  Numbers maps = Numbers::list(), list = Numbers::list();
  for (const FieldPageData& data : fields) {
    const PhaseMap& map = data.result->map;
    const Thinning kept(map);
    std::size_t at = 0;
    while (at < known.size() && !same_map(*known[at], map)) ++at;
    if (at == known.size()) {
      known.push_back(&map);
      maps.push_back(map_of(map, shortened(data.result->numbers), kept, block));
    }
    list.push_back(field_of(data, at, kept, block));
  }
  document["maps"] = std::move(maps);
  document["fields"] = std::move(list);
}

}  // namespace arenite::report
