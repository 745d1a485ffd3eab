#include "solid/stress/sample_means.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "statistics/estimate.hpp"
#include "statistics/numbers.hpp"

namespace arenite::stress {
namespace {

std::optional<double> stored_mean(const Numbers& numbers, std::string_view name) {
  const Numbers* mean = numbers.at_path("/stress/" + std::string(name) + "/sample_mean_Pa/value");
  return mean && mean->is_number() ? std::optional(mean->get<double>()) : std::nullopt;
}

/// Those that the statistics consider; where the options leave none, all that are not void.
Selection nodes_of(const FieldResult& sample) {
  if (sample.field.size() == 0) return {};
  try {
    return select(sample.map, sample.field, options_of(sample));
  } catch (const InputError&) {
    Selection all;
    all.set = mapped(sample.map.phase, [](Phase phase) { return set_of(phase, GrainClass::none); });
    all.block_area = {static_cast<double>(sample.map.size())};
    return all;
  }
}

}  // namespace

StressOptions options_of(const FieldResult& sample) {
  StressOptions options;
  options.components.assign(std::begin(all_components), std::end(all_components));
  const Numbers* said = sample.numbers.at_path("/stress/options");
  if (!said) return options;
  options.clamp_rows = said->value("clamp_rows", options.clamp_rows);
  options.leave_out_surface = said->value("leave_out_surface", options.leave_out_surface);
  options.leave_out_unloaded = said->value("leave_out_unloaded", options.leave_out_unloaded);
  options.mean_over_area = said->value("sample_mean_over", std::string()) == "area";
  options.blocks = said->value("blocks", options.blocks);
  return options;
}

double SampleMeans::of(const FieldQuantity& quantity) const {
  if (const auto stored = stored_mean(sample_.numbers, quantity.name)) return *stored;
  if (!nodes_) nodes_ = nodes_of(sample_);
  const std::vector<double> values = values_of(quantity, sample_.field);
  double sum = 0, nodes = 0;
  for (std::size_t k = 0; k < values.size(); ++k)
    if (nodes_->set[k] != NodeSet::left_out) sum += values[k], ++nodes;
  const bool over_area = quantity.unit == "Pa" && options_of(sample_).mean_over_area;
  if (over_area) {
    nodes = 0;
    for (const double area : nodes_->block_area) nodes += area;
  }
  return nodes > 0 ? sum / nodes : statistics::unknown;
}

const FieldQuantity* SampleMeans::strongest() const {
  const FieldQuantity* strongest = nullptr;
  double largest = 0;
  for (const FieldQuantity& quantity : field_quantities()) {
    if (!quantity.is_stored() || quantity.unit != "Pa" || !has(sample_.field, quantity)) continue;
    const double size = std::abs(of(quantity));
    if (size > largest) largest = size, strongest = &quantity;
  }
  return strongest;
}

double SampleMeans::scale() const {
  const FieldQuantity* by = strongest();
  return by ? std::abs(of(*by)) : 1;
}

double sample_mean(const VoxelResult& sample, const VoxelQuantity& quantity) {
  if (const auto stored = stored_mean(sample.numbers, quantity.name)) return *stored;
  const Numbers* said = sample.numbers.at_path("/stress/options/clamp_layers");
  const int left_out = said ? said->get<int>() : 0;
  const VoxelMap& map = sample.map;
  const std::size_t first = map.index(0, 0, left_out), last = map.index(0, 0, map.depth - left_out);
  double sum = 0, voxels = 0;
  for (std::size_t k = first; k < std::min(last, sample.field.size()); ++k)
    if (map.phase[k] != Phase::empty) sum += quantity.of(sample.field, k), ++voxels;
  return voxels > 0 ? sum / voxels : statistics::unknown;
}

}  // namespace arenite::stress
