#include "thermal/imaging/label_grains.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "core/joined_sets.hpp"

namespace arenite::imaging {

std::vector<std::int32_t> connected_particles(const PhaseMap& map) {
  std::vector<std::int32_t> label(map.size(), -1);
  JoinedSets sets;
  const auto width = static_cast<std::size_t>(map.width);
  for (std::size_t i = 0; i < label.size(); ++i) {
    if (map.phase[i] != Phase::particle) continue;
    const std::int32_t before = i % width > 0 ? label[i - 1] : -1, below = i >= width ? label[i - width] : -1;
    if (before >= 0 && below >= 0) label[i] = before == below ? before : sets.join(before, below);
    else label[i] = before >= 0 ? before : below >= 0 ? below : sets.add();
  }
  for (std::int32_t& l : label)
    if (l >= 0) l = sets.find(l);
  return label;
}

LabelReport label_grains(PhaseMap& map, const LabelOptions& options) {
  if (!(options.smoothing >= 0) || !std::isfinite(options.smoothing))
    throw InputError(fmt::format("the smoothing of the watershed is {:g} nodes; give zero or more", options.smoothing));
  map.grain = options.way == Labelling::components ? connected_particles(map) : watershed(map, options.smoothing);
  std::vector<std::int32_t> number;
  std::vector<std::size_t> nodes;
  for (std::int32_t& g : map.grain) {
    if (g < 0) continue;
    if (static_cast<std::size_t>(g) >= number.size()) number.resize(static_cast<std::size_t>(g) + 1, -1);
    std::int32_t& mine = number[static_cast<std::size_t>(g)];
    if (mine < 0) {
      mine = static_cast<std::int32_t>(nodes.size());
      nodes.push_back(0);
    }
    ++nodes[static_cast<std::size_t>(mine)];
    g = mine;
  }
  map.grain_class.assign(nodes.size(), GrainClass::none);
  LabelReport report;
  report.grains = static_cast<std::int32_t>(nodes.size());
  std::size_t all = 0, largest = 0;
  for (const std::size_t n : nodes) {
    all += n;
    largest = std::max(largest, n);
  }
  if (all > 0) report.largest_share = static_cast<double>(largest) / static_cast<double>(all);
  return report;
}

}  // namespace arenite::imaging
