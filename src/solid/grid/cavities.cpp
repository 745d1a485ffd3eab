#include <algorithm>
#include <utility>

#include "core/joined_sets.hpp"
#include "core/problems.hpp"
#include "model/packing.hpp"
#include "solid/grid/cavities.hpp"

namespace arenite::grid {
namespace {

/// Which phases are flooded.
enum class Flooded { voids, pores, solid };  // empty; not particle; not empty

/// Connected sets of nodes, in the order of their first node.
struct Components {
  std::vector<std::int32_t> label;  ///< one a node; -1: another phase
  std::vector<std::int64_t> nodes;  ///< one a component
  std::vector<std::uint8_t> sides;  ///< bit Side (model/packing.hpp) of the edges of the map that it touches
};

struct Run {
  int y, first, last;
};

bool is_flooded(Phase phase, Flooded phases) {
  if (phases == Flooded::pores) return phase != Phase::particle;
  return (phase == Phase::empty) == (phases == Flooded::voids);
}

std::vector<Run> runs_of(const PhaseMap& map, Flooded phases) {
  std::vector<Run> runs;
  for (int y = 0; y < map.height; ++y) {
    const Phase* row = map.phase.data() + map.index(0, y);
    for (int x = 0; x < map.width; ++x) {
      if (!is_flooded(row[x], phases)) continue;
      const int first = x;
      while (x + 1 < map.width && is_flooded(row[x + 1], phases)) ++x;
      runs.push_back({y, first, x});
    }
  }
  return runs;
}

/// Joins runs of neighbouring rows that share a column, or a corner too if `reach` is 1.
JoinedSets joined(const std::vector<Run>& runs, int reach) {
  JoinedSets sets(runs.size());
  std::size_t below = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    while (runs[below].y < runs[k].y - 1 ||
           (runs[below].y == runs[k].y - 1 && runs[below].last + reach < runs[k].first))
      ++below;
    for (std::size_t b = below; runs[b].y == runs[k].y - 1 && runs[b].first <= runs[k].last + reach; ++b)
      sets.join(static_cast<std::int32_t>(b), static_cast<std::int32_t>(k));
  }
  return sets;
}

/// Labels by runs along rows and their union; neighbours are the four nearest nodes, or all eight.
Components find_components(const PhaseMap& map, Flooded phases, bool eight_connected) {
  const auto runs = runs_of(map, phases);
  JoinedSets sets = joined(runs, eight_connected ? 1 : 0);
  Components found;
  found.label.assign(map.size(), -1);
  std::vector<std::int32_t> label_of_root(runs.size(), -1);
  for (std::size_t k = 0; k < runs.size(); ++k) {
    const Run& run = runs[k];
    auto& label = label_of_root[sets.find(static_cast<std::int32_t>(k))];
    if (label < 0) {
      label = static_cast<std::int32_t>(found.nodes.size());
      found.nodes.push_back(0);
      found.sides.push_back(0);
    }
    found.nodes[label] += run.last - run.first + 1;
    found.sides[label] =
        static_cast<std::uint8_t>(found.sides[label] | (run.first == 0) << left | (run.last == map.width - 1) << right |
                                  (run.y == 0) << bottom | (run.y == map.height - 1) << top);
    std::fill_n(found.label.begin() + static_cast<std::ptrdiff_t>(map.index(run.first, run.y)),
                run.last - run.first + 1, label);
  }
  return found;
}

}  // namespace

Cavities find_cavities(const PhaseMap& map, Cavity kind, const CavityRules& rules) {
  if (rules.fewest_nodes < 0)
    throw refusal("the smallest number of nodes of a cavity is {}; give 1 or more", rules.fewest_nodes);
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

}  // namespace arenite::grid
