#include "solid/stress/selection.hpp"

#include <algorithm>
#include <cstdint>

#include "core/problems.hpp"

namespace arenite::stress {
namespace {

void check_selected(const PhaseMap& map, const StressField& field, const StressOptions& options) {
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

}  // namespace

NodeSet set_of(Phase phase, GrainClass of_grain) {
  if (phase == Phase::empty) return NodeSet::left_out;
  if (phase == Phase::matrix) return NodeSet::matrix;
  switch (of_grain) {
    case GrainClass::small: return NodeSet::small;
    case GrainClass::large: return NodeSet::large;
    default: return NodeSet::unclassed;
  }
}

void check_clamp_rows(const PhaseMap& map, int rows) {
  if (rows < 0) throw refusal("the number of clamp rows left out is {}; give 0 or more", rows);
  if (rows > (map.height - 1) / 2)
    throw refusal("leaving out {} rows at each clamp leaves none of the map's {}; leave out fewer", rows, map.height);
}

Selection select(const PhaseMap& map, const StressField& field, const StressOptions& options) {
  check_selected(map, field, options);
  Selection selection;
  const int first = options.clamp_rows, rows = map.height - 2 * first, k = options.blocks;
  selection.set.assign(map.size(), NodeSet::left_out);
  selection.block.assign(map.size(), 0);
  selection.blocks = k * k, selection.columns = k;
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

}  // namespace arenite::stress
