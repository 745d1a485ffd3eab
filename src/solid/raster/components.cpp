#include "solid/raster/components.hpp"

#include <algorithm>

#include "core/joined_sets.hpp"
#include "model/domain.hpp"

namespace arenite::raster {
namespace {

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

}  // namespace

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
    found.sides[label] = static_cast<std::uint8_t>(
        found.sides[label] | (run.first == 0) << left | (run.last == map.width - 1) << right | (run.y == 0) << bottom |
        (run.y == map.height - 1) << top);
    std::fill_n(found.label.begin() + static_cast<std::ptrdiff_t>(map.index(run.first, run.y)), run.last - run.first + 1, label);
  }
  return found;
}

}  // namespace arenite::raster
