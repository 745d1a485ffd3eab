#include "solid/stress/selection.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace arenite::stress {
namespace {

void check_options(const PhaseMap& map, const StressOptions& options, std::vector<Problem>& problems) {
  const auto add = [&](std::string message) { problems.push_back({{}, 0, 0, std::move(message)}); };
  if (options.components.empty()) add("no component of the stress is asked for; name at least one, such as sigma_yy");
  if (options.clamp_rows < 0) add("the number of clamp rows left out is negative; give 0 or more");
  if (options.blocks < 1 || options.blocks > 64) add("errors need between 1 and 64 blocks a side");
  if (options.clamp_rows >= 0 && 2 * options.clamp_rows >= map.height)
    add(fmt::format("leaving out {} rows at each clamp leaves none of the map's {}; leave out fewer", options.clamp_rows, map.height));
}

void check_field(const PhaseMap& map, const StressField& field, std::vector<Problem>& problems) {
  const std::size_t n = map.size();
  if (field.width != map.width || field.height != map.height || field.xx.size() != n || field.yy.size() != n || field.xy.size() != n) {
    problems.push_back({{}, 0, 0, fmt::format("the stress field has {} x {} nodes and the phase map {} x {}; both must come from the same sample",
                                              field.width, field.height, map.width, map.height)});
    return;
  }
  double sum = 0;  // a number that is not finite shows in the sum of products with zero
  for (std::size_t i = 0; i < n; ++i) sum += 0 * field.xx[i] + 0 * field.yy[i] + 0 * field.xy[i];
  if (!(sum == 0)) problems.push_back({{}, 0, 0, "a stress of the field is not a finite number; solve the sample again"});
}

NodeSet set_of(const PhaseMap& map, std::size_t i) {
  if (map.phase[i] == Phase::empty) return NodeSet::left_out;
  if (map.phase[i] == Phase::matrix) return NodeSet::matrix;
  switch (map.grain_class[static_cast<std::size_t>(map.grain[i])]) {
    case GrainClass::small: return NodeSet::small;
    case GrainClass::large: return NodeSet::large;
    default: return NodeSet::unclassed;
  }
}

}  // namespace

bool on_surface(const PhaseMap& map, int x, int y) {
  const std::size_t here = map.index(x, y);
  for (int v = std::max(0, y - 1); v <= std::min(map.height - 1, y + 1); ++v)
    for (int u = std::max(0, x - 1); u <= std::min(map.width - 1, x + 1); ++u) {
      const std::size_t there = map.index(u, v);
      if (map.phase[there] != map.phase[here] || map.grain[there] != map.grain[here]) return true;
    }
  return false;
}

Selection select(const PhaseMap& map, const StressField& field, const StressOptions& options) {
  check(map);
  std::vector<Problem> problems;
  check_options(map, options, problems);
  check_field(map, field, problems);
  if (!problems.empty()) throw InputError(std::move(problems));
  Selection selection;
  const int first = options.clamp_rows, rows = map.height - 2 * first, k = options.blocks;
  selection.set.assign(map.size(), NodeSet::left_out);
  selection.block.assign(map.size(), 0);
  selection.blocks = k * k;
  selection.block_area.assign(static_cast<std::size_t>(k * k), 0);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const std::size_t i = map.index(x, y);
      const NodeSet set = set_of(map, i);
      if (y < first || y >= first + rows) {
        selection.clamp_nodes += set != NodeSet::left_out;
        continue;
      }
      const auto b = static_cast<std::uint16_t>(static_cast<std::int64_t>(y - first) * k / rows * k + static_cast<std::int64_t>(x) * k / map.width);
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
    throw InputError("no node is left to measure stresses in; the map is void, or the options leave out every node that is not");
  return selection;
}

}  // namespace arenite::stress
