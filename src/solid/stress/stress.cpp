#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/problems.hpp"
#include "solid/stress/grains.hpp"
#include "solid/stress/set_statistics.hpp"
#include "solid/stress/stress.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::stress {
namespace {

using statistics::BlockedSample;
using statistics::described;
using statistics::put;

/// The sets that do not overlap; unclassed are particles without class.
enum class NodeSet : std::uint8_t { left_out, matrix, small, large, unclassed };

/// What is reported: a range of these.
struct NamedSet {
  const char* name;
  NodeSet first, last;
};
constexpr NamedSet named_sets[] = {{"all", NodeSet::matrix, NodeSet::unclassed},
                                   {"particle", NodeSet::small, NodeSet::unclassed},
                                   {"large", NodeSet::large, NodeSet::large},
                                   {"small", NodeSet::small, NodeSet::small},
                                   {"matrix", NodeSet::matrix, NodeSet::matrix}};

/// Which nodes count, and in which block each lies.
struct Selection {
  std::size_t nodes = 0;                           ///< considered: particle or matrix
  std::size_t clamp_nodes = 0, surface_nodes = 0;  ///< left out as clamp rows, as outermost ones
  std::size_t unloaded_nodes = 0;                  ///< particle or matrix without any stress beyond the clamp rows
  std::vector<NodeSet> set;                        ///< one a node
  std::vector<std::uint16_t> block;                ///< one a node
  int blocks = 1;                                  ///< in all
  std::vector<double> block_area;                  ///< nodes of a block beyond the clamp rows, void included
};

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

NodeSet set_of(const PhaseMap& map, std::size_t i) {
  if (map.phase[i] == Phase::empty) return NodeSet::left_out;
  if (map.phase[i] == Phase::matrix) return NodeSet::matrix;
  switch (map.grain_class[static_cast<std::size_t>(map.grain[i])]) {
    case GrainClass::small: return NodeSet::small;
    case GrainClass::large: return NodeSet::large;
    default: return NodeSet::unclassed;
  }
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
      const NodeSet set = set_of(map, i);
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

BlockedSample gather(const Selection& selection, const StressField& field, Component component,
                     const NamedSet& wanted) {
  BlockedSample sample{{}, {}, selection.blocks};
  sample.x.reserve(selection.nodes);
  sample.block.reserve(selection.nodes);
  for (std::size_t i = 0; i < selection.set.size(); ++i)
    if (selection.set[i] >= wanted.first && selection.set[i] <= wanted.last) {
      sample.x.push_back(value(field, component, i));
      sample.block.push_back(selection.block[i]);
    }
  return sample;
}

/// Puts the means of the sample; returns what divides its stresses, all and without each block. One of them is not
/// zero.
Normaliser normalise(const Selection& selection, const BlockedSample& all, const StressOptions& options, Numbers& to) {
  const std::vector<Powers> blocks = powers_by_block(all, 0);
  const std::vector<double>& areas = selection.block_area;
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  Powers total;
  for (const Powers& block : blocks) total += block;
  Normaliser normaliser;
  normaliser.over_mean = !near_zero(total.d1 / total.n, total.d2 / total.n);
  const auto values = [&](const Powers& s, double of_area) {
    const double scale =
        !normaliser.over_mean ? std::sqrt(s.d2 / s.n) : s.d1 / (options.mean_over_area ? of_area : s.n);
    return std::vector<double>{s.d1 / s.n, s.d1 / of_area, scale};
  };
  std::vector<std::vector<double>> replicates;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Powers rest = total - blocks[b];
    const bool any = rest.n > 0 && rest.d2 > 0;
    normaliser.without.push_back(any ? values(rest, area - areas[b])[2] : unknown);
    if (any) replicates.push_back(values(rest, area - areas[b]));
  }
  const auto whole = values(total, area);
  const auto e = statistics::with_errors(whole, replicates);
  normaliser.value = whole[2];
  put(to, "sample_mean_Pa", options.mean_over_area ? e[1] : e[0], "Pa", "Mean by which stresses are divided");
  put(to, "mean_over_nodes_Pa", e[0], "Pa", "Mean over nodes of particles and matrix", Trait::detail);
  put(to, "mean_over_area_Pa", e[1], "Pa", "Mean over the whole area, the void as zero", Trait::detail);
  to["normalised_by"] = normaliser.over_mean ? "mean" : "root mean square";
  return normaliser;
}

/// Not known where the component is zero in every node.
Numbers measure_component(const Selection& selection, const StressField& field, Component component,
                          const StressOptions& options, std::vector<std::string>& notes) {
  const std::string stress = name_of(component);
  BlockedSample all = gather(selection, field, component, named_sets[0]);
  if (std::ranges::all_of(all.x, [](double sigma) { return sigma == 0; })) {
    notes.push_back(
        fmt::format("{} is zero in every node, so there is nothing to normalise by; load the sample", stress));
    return {};
  }
  Numbers j = Numbers::tree();
  const Normaliser normaliser = normalise(selection, all, options, j);
  if (!normaliser.over_mean)
    notes.push_back(
        fmt::format("the sample's mean of {} is near zero, below a tenth of its root mean square: stresses are given "
                    "over the latter",
                    stress));
  for (const NamedSet& set : named_sets) {
    BlockedSample sample = &set == named_sets ? std::move(all) : gather(selection, field, component, set);
    if (!sample.x.empty())
      j["sets"][set.name] = describe(fmt::format("{} in {}", stress, set.name), sample, normaliser, notes);
  }
  return j;
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
    if (Numbers measured = measure_component(selection, field, component, options, said); measured.is_known()) {
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
