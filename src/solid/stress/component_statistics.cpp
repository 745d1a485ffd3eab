#include "solid/stress/component_statistics.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "solid/stress/set_statistics.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::stress {
namespace {

using statistics::BlockedSample;
using statistics::put;
using statistics::unknown;

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

BlockedSample gather(const Selection& selection, const StressAt& stress, const NamedSet& wanted) {
  BlockedSample sample{{}, {}, selection.blocks};
  sample.x.reserve(selection.nodes);
  sample.block.reserve(selection.nodes);
  for (std::size_t i = 0; i < selection.set.size(); ++i)
    if (selection.set[i] >= wanted.first && selection.set[i] <= wanted.last) {
      sample.x.push_back(stress(i));
      sample.block.push_back(selection.block[i]);
    }
  return sample;
}

/// Puts the means of the sample; returns what divides its stresses, all and without each block. One of them is not
/// zero.
Normaliser normalise(const Selection& selection, const BlockedSample& all, bool mean_over_area, Numbers& to) {
  const std::vector<Powers> blocks = powers_by_block(all, 0);
  const std::vector<double>& areas = selection.block_area;
  const double area = std::accumulate(areas.begin(), areas.end(), 0.0);
  Powers total;
  for (const Powers& block : blocks) total += block;
  Normaliser normaliser;
  normaliser.over_mean = !near_zero(total.d1 / total.n, total.d2 / total.n);
  const auto values = [&](const Powers& s, double of_area) {
    const double scale = !normaliser.over_mean ? std::sqrt(s.d2 / s.n) : s.d1 / (mean_over_area ? of_area : s.n);
    return std::vector<double>{s.d1 / s.n, s.d1 / of_area, scale};
  };
  normaliser.columns = selection.columns;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    const Powers rest = total - blocks[b];
    normaliser.without.push_back(rest.n > 0 && rest.d2 > 0 ? values(rest, area - areas[b])[2] : unknown);
  }
  const std::vector<double> column_areas = by_column(areas, selection.columns);
  const std::vector<Powers> columns = by_column(blocks, selection.columns);
  std::vector<std::vector<double>> replicates;
  for (std::size_t c = 0; c < columns.size(); ++c)
    if (const Powers rest = total - columns[c]; rest.n > 0 && rest.d2 > 0)
      replicates.push_back(values(rest, area - column_areas[c]));
  const auto whole = values(total, area);
  const auto e = statistics::with_errors(whole, replicates);
  normaliser.value = whole[2];
  put(to, "sample_mean_Pa", mean_over_area ? e[1] : e[0], "Pa",
      normaliser.over_mean ? "Mean by which stresses are divided" : "Mean of the sample");
  put(to, "mean_over_nodes_Pa", e[0], "Pa", "Mean over nodes of particles and matrix", Trait::detail);
  put(to, "mean_over_area_Pa", e[1], "Pa", "Mean over the whole area, the void as zero", Trait::detail);
  if (!normaliser.over_mean)
    put(to, "root_mean_square_Pa", e[2], "Pa", "Root mean square, by which stresses are divided");
  to["normalised_by"] = normaliser.over_mean ? "mean" : "root mean square";
  return normaliser;
}

}  // namespace

Numbers component_statistics(const Selection& selection, const std::string& name, const StressAt& stress,
                             bool mean_over_area, std::vector<std::string>& notes) {
  BlockedSample all = gather(selection, stress, named_sets[0]);
  if (std::ranges::all_of(all.x, [](double sigma) { return sigma == 0; })) {
    notes.push_back(
        fmt::format("{} is zero in every node, so there is nothing to normalise by: no node carries load", name));
    return {};
  }
  Numbers j = Numbers::tree();
  const Normaliser normaliser = normalise(selection, all, mean_over_area, j);
  if (!normaliser.over_mean)
    notes.push_back(
        fmt::format("the sample's mean of {} is near zero, below a tenth of its root mean square: stresses are given "
                    "over the latter",
                    name));
  for (const NamedSet& set : named_sets) {
    BlockedSample sample = &set == named_sets ? std::move(all) : gather(selection, stress, set);
    if (!sample.x.empty())
      j["sets"][set.name] = describe(fmt::format("{} in {}", name, set.name), sample, normaliser, notes);
  }
  return j;
}

}  // namespace arenite::stress
