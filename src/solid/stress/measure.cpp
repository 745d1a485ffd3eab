#include <fmt/format.h>

#include <cmath>

#include "core/error.hpp"
#include "statistics/jackknife.hpp"
#include "solid/stress/selection.hpp"
#include "solid/stress/set_statistics.hpp"
#include "solid/stress/stress.hpp"

namespace arenite::stress {
namespace {

using statistics::BlockedSample;

double value(const StressField& field, Component component, std::size_t i) {
  switch (component) {
    case Component::xx: return field.xx[i];
    case Component::xy: return field.xy[i];
    case Component::hydrostatic: return 0.5 * (field.xx[i] + field.yy[i]);
    default: return field.yy[i];
  }
}

template <class Wanted>
BlockedSample gather(const Selection& selection, const StressField& field, Component component, Wanted&& wanted) {
  BlockedSample sample{{}, {}, selection.blocks};
  sample.x.reserve(selection.nodes);
  sample.block.reserve(selection.nodes);
  for (std::size_t i = 0; i < selection.set.size(); ++i)
    if (wanted(selection.set[i])) {
      sample.x.push_back(value(field, component, i));
      sample.block.push_back(selection.block[i]);
    }
  return sample;
}

struct BlockSums {
  double n = 0, sum = 0, square = 0, area = 0;
};

/// Means of the sample and what divides its stresses, all and without each block.
Normaliser normalise(const Selection& selection, const BlockedSample& all, const StressOptions& options, ComponentStatistics& result) {
  std::vector<BlockSums> blocks(static_cast<std::size_t>(selection.blocks));
  for (std::size_t i = 0; i < all.x.size(); ++i) {
    BlockSums& b = blocks[all.block[i]];
    b.n += 1;
    b.sum += all.x[i];
    b.square += all.x[i] * all.x[i];
  }
  BlockSums total;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    blocks[b].area = selection.block_area[b];
    total = {total.n + blocks[b].n, total.sum + blocks[b].sum, total.square + blocks[b].square, total.area + blocks[b].area};
  }
  if (!(total.square > 0))
    throw InputError(fmt::format("{} is zero in every node, so there is nothing to normalise by; load the sample", name_of(result.component)));
  Normaliser normaliser;
  normaliser.over_mean = result.over_mean = !near_zero(total.sum / total.n, total.square / total.n);
  const auto values = [&](const BlockSums& s) {
    const double scale = !normaliser.over_mean ? std::sqrt(s.square / s.n) : s.sum / (options.mean_over_area ? s.area : s.n);
    return std::vector<double>{s.sum / s.n, s.sum / s.area, scale};
  };
  std::vector<std::vector<double>> replicates;
  for (const BlockSums& b : blocks) {
    const BlockSums rest{total.n - b.n, total.sum - b.sum, total.square - b.square, total.area - b.area};
    const bool any = rest.n > 0 && rest.square > 0;
    normaliser.without.push_back(any ? values(rest)[2] : unknown);
    if (any) replicates.push_back(values(rest));
  }
  const auto whole = values(total);
  const auto e = statistics::with_errors(whole, replicates);
  normaliser.value = whole[2];
  result.mean_over_nodes = e[0];
  result.mean_over_area = e[1];
  result.sample_mean = options.mean_over_area ? e[1] : e[0];
  return normaliser;
}

ComponentStatistics measure_component(const Selection& selection, const StressField& field, Component component,
                                      const StressOptions& options, std::vector<std::string>& notes) {
  ComponentStatistics result;
  result.component = component;
  const std::string stress = name_of(component);
  BlockedSample all = gather(selection, field, component, [](NodeSet s) { return s != NodeSet::left_out; });
  const Normaliser normaliser = normalise(selection, all, options, result);
  if (!result.over_mean)
    notes.push_back(fmt::format("the sample's mean of {} is near zero, below a tenth of its root mean square: stresses are given over the latter", stress));
  const auto add = [&](const std::string& name, BlockedSample&& sample) {
    if (!sample.x.empty()) result.sets.emplace_back(name, describe(stress + " in " + name, sample, normaliser, notes));
  };
  add("all", std::move(all));
  add("particle", gather(selection, field, component, [](NodeSet s) { return s > NodeSet::matrix; }));
  add("large", gather(selection, field, component, [](NodeSet s) { return s == NodeSet::large; }));
  add("small", gather(selection, field, component, [](NodeSet s) { return s == NodeSet::small; }));
  add("matrix", gather(selection, field, component, [](NodeSet s) { return s == NodeSet::matrix; }));
  return result;
}

}  // namespace

const char* name_of(Component component) {
  switch (component) {
    case Component::xx: return "sigma_xx";
    case Component::xy: return "sigma_xy";
    case Component::hydrostatic: return "sigma_hyd";
    default: return "sigma_yy";
  }
}

Statistics measure(const PhaseMap& map, const StressField& field, const StressOptions& options) {
  const Selection selection = select(map, field, options);
  Statistics result;
  result.options = options;
  result.nodes = selection.nodes;
  result.clamp_nodes = selection.clamp_nodes;
  result.surface_nodes = selection.surface_nodes;
  result.unloaded_nodes = selection.unloaded_nodes;
  for (const Component component : options.components)
    result.components.push_back(measure_component(selection, field, component, options, result.notes));
  result.grains = measure_grains(map, field, options.clamp_rows, options.blocks);
  return result;
}

}  // namespace arenite::stress
