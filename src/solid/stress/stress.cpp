#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/problems.hpp"
#include "solid/stress/component_statistics.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::stress {
namespace {

using statistics::described;

void check(const PhaseMap& map, const StressField& field, const StressOptions& options) {
  arenite::check(map);
  Problems problems;
  problems.unless(!options.components.empty(), "no stress component is selected; name at least one, such as sigma_yy");
  check_clamp_rows(map, options.clamp_rows);
  problems.unless(options.blocks >= 1 && options.blocks <= 64, "errors need between 1 and 64 blocks per side");
  const std::size_t n = map.size();
  const bool fits = field.width == map.width && field.height == map.height && field.xx.size() == n &&
                    field.yy.size() == n && field.xy.size() == n;
  problems.unless(fits,
                  "the stress field has {} x {} nodes and the phase map {} x {}; both must come from the same sample",
                  field.width, field.height, map.width, map.height);
  double sum = 0;  // a number that is not finite shows in the sum of products with zero
  for (std::size_t i = 0; fits && i < n; ++i) sum += 0 * field.xx[i] + 0 * field.yy[i] + 0 * field.xy[i];
  problems.unless(sum == 0, "a stress of the field is not a finite number; solve the sample again");
  problems.raise();
}

NodeSet set_at(const PhaseMap& map, std::size_t i) {
  const bool particle = map.phase[i] == Phase::particle;
  return set_of(map.phase[i], particle ? map.grain_class[static_cast<std::size_t>(map.grain[i])] : GrainClass::none);
}

/// Whether one of a node's eight neighbours is of another phase or grain; beyond the map there is none.
bool on_surface(const PhaseMap& map, int x, int y) {
  const std::size_t here = map.index(x, y);
  for (int v = std::max(0, y - 1); v <= std::min(map.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(map.width - 1, x + 1); ++u) {
      const std::size_t there = map.index(u, v);
      if (map.phase[there] != map.phase[here] || map.grain[there] != map.grain[here]) return true;
    }
  return false;
}

/// Throws InputError where the options, the map and the field do not fit each other or leave nothing.
Selection select(const PhaseMap& map, const StressField& field, const StressOptions& options) {
  check(map, field, options);
  Selection selection;
  const int first = options.clamp_rows, rows = map.height - 2 * first, k = options.blocks;
  selection.set.assign(map.size(), NodeSet::left_out);
  selection.block.assign(map.size(), 0);
  selection.blocks = k * k;
  selection.block_area.assign(static_cast<std::size_t>(k * k), 0);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const std::size_t i = map.index(x, y);
      const NodeSet set = set_at(map, i);
      if (y < first || y >= first + rows) {
        selection.clamp_nodes += set != NodeSet::left_out;
        continue;
      }
      const auto b = static_cast<std::uint16_t>(static_cast<std::int64_t>(y - first) * k / rows * k +
                                                static_cast<std::int64_t>(x) * k / map.width);
      selection.block[i] = b;
      selection.block_area[b] += 1;
      if (set == NodeSet::left_out) continue;
      const bool unloaded = field.xx[i] == 0 && field.yy[i] == 0 && field.xy[i] == 0;
      selection.unloaded_nodes += unloaded;
      if (options.leave_out_unloaded && unloaded) continue;
      if (options.leave_out_surface && on_surface(map, x, y)) {
        ++selection.surface_nodes;
        continue;
      }
      selection.set[i] = set;
      ++selection.nodes;
    }
  if (selection.nodes == 0)
    throw InputError("no node is left to measure stresses in; the map is void, or the options exclude all other nodes");
  return selection;
}

double value(const StressField& field, Component component, std::size_t i) {
  switch (component) {
    case Component::xx: return field.xx[i];
    case Component::xy: return field.xy[i];
    case Component::hydrostatic: return 0.5 * (field.xx[i] + field.yy[i]);
    default: return field.yy[i];
  }
}

}  // namespace

const char* name_of(Component component) {
  constexpr const char* names[] = {"sigma_yy", "sigma_xx", "sigma_xy", "sigma_hyd"};
  return names[static_cast<int>(component)];
}

void check_clamp_rows(const PhaseMap& map, int rows) {
  if (rows < 0) throw refusal("the number of clamp rows left out is {}; give 0 or more", rows);
  if (rows > (map.height - 1) / 2)
    throw refusal("leaving out {} rows at each clamp leaves none of the map's {}; leave out fewer", rows, map.height);
}

Statistics measure(const PhaseMap& map, const StressField& field, const StressOptions& options) {
  const Selection selection = select(map, field, options);
  Numbers j{
      {"nodes", described(selection.nodes, "", "Nodes of particles and matrix that are considered")},
      {"clamp_nodes", described(selection.clamp_nodes, "", "Nodes left out as clamp rows")},
      {"surface_nodes", described(selection.surface_nodes, "", "Nodes left out that border another phase or grain")},
      {"unloaded_nodes", described(selection.unloaded_nodes, "", "Nodes without any stress")},
      {"options",
       {{"clamp_rows", options.clamp_rows},
        {"leave_out_surface", options.leave_out_surface},
        {"leave_out_unloaded", options.leave_out_unloaded},
        {"sample_mean_over", options.mean_over_area ? "area" : "particles and matrix"},
        {"blocks", options.blocks}}}};
  j["options"].mark(Trait::detail);
  std::vector<std::pair<Component, std::string>> notes;
  bool any = false;
  for (const Component component : options.components) {
    std::vector<std::string> said;
    Numbers measured = component_statistics(
        selection, name_of(component), [&](std::size_t i) { return value(field, component, i); },
        options.mean_over_area, said);
    if (measured.is_known()) {
      j[name_of(component)] = std::move(measured);
      any = true;
    }
    for (std::string& note : said) notes.emplace_back(component, std::move(note));
  }
  if (!any) throw InputError(notes.front().second);
  GrainStresses grains = measure_grains(map, field, options.clamp_rows, options.blocks);
  if (!grains.nodes.empty()) j["grains"] = numbers(grains);
  return {std::move(j), std::move(grains), std::move(notes)};
}

Numbers numbers(const Statistics& s, bool curves, std::span<const Component> components) {
  const auto wanted = [&](Component component) { return std::ranges::count(components, component) > 0; };
  Numbers j = s.numbers, notes = Numbers::list();
  for (const Component component : all_components)
    if (!wanted(component)) j.erase(name_of(component));
  for (const auto& [component, note] : s.notes)
    if (wanted(component)) notes.push_back(note);
  j["notes"] = std::move(notes);
  if (!curves) erase(j, Trait::curve);
  return j;
}

std::string to_text(const Statistics& s) {
  Numbers shown = numbers(s);
  erase(shown, Trait::detail);
  return arenite::to_text(shown);
}

}  // namespace arenite::stress
