#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "grains/fields/driven.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "grains/fields/steady_state.hpp"

namespace arenite::fields {
namespace {

using statistics::described;
using Kind = dem::SideDrive::Kind;

constexpr double largest_departure = 0.05;  // of a load from what was asked for

/// What a side was to press with and what it did, row by row of the history: Pa, or N of a side under a force.
struct Load {
  std::vector<double> asked, reached;
};

const dem::Programme* programme_of(const dem::Stage& stage, int side) {
  const auto drives = [&](const dem::Programme& p) {
    return p.of.is_of_side() && p.of.side == side && !p.of.is(dem::Programme::What::velocity);
  };
  const auto at = std::ranges::find_if(stage.programmes, drives);
  return at == stage.programmes.end() ? nullptr : &*at;
}

double thickness_of(const Domain& domain) { return domain.thickness; }
double thickness_of(const DomainIn<3>& /*domain*/) { return 1; }

/// Area that a side presses on in each row, m^2; 1 of a side under a force.
template <int D> std::vector<double> areas(const StageResultIn<D>& result, int side, Kind kind) {
  const auto* time = result.history.find("time");
  std::vector<double> area(time->size(), 1.0);
  if (kind == Kind::force) return area;
  for (int beside = 0; beside < sides_in<D>; beside += 2) {
    if (axis_of(beside) == axis_of(side)) continue;
    const auto *from = result.history.find(std::string(any_side_names[beside]) + "_position"),
               *to = result.history.find(std::string(any_side_names[beside + 1]) + "_position");
    if (!from || !to) return {};
    for (std::size_t k = 0; k < area.size(); ++k) area[k] *= (*to)[k] - (*from)[k];
  }
  const double thickness = thickness_of(result.snapshots.back().packing.domain);
  for (double& each : area) each *= thickness;
  return area;
}

/// Empty where a side does not press, or presses with a force that changes from increment to increment.
template <int D> Load load_of(const StageResultIn<D>& result, const dem::Stage& stage, int side) {
  const dem::SideDrive& drive = stage.side[side];
  const auto *time = result.history.find("time"),
             *force = result.history.find(std::string(any_side_names[side]) + "_force");
  if (!drive.presses() || !time || !force) return {};
  if (stage.cycles && stage.cycles->side == side) return {};
  const auto area = areas(result, side, drive.kind);
  const dem::Programme* programme = programme_of(stage, side);
  const double begin = time->back() - length_of(result, stage);
  Load load;
  for (std::size_t k = 0; k < area.size(); ++k) {
    load.asked.push_back(programme ? programme->at((*time)[k] - begin) : drive.value);
    load.reached.push_back((*force)[k] / area[k]);
  }
  return load;
}

/// Of what a servo lets through: the departure from the load, over the part in which that only fluctuates.
SteadyState departure(const Load& load) {
  std::vector<double> off;
  for (std::size_t k = 0; k < load.asked.size(); ++k) off.push_back(load.reached[k] - load.asked[k]);
  SteadyState state = find_steady_state(off);
  const auto steady = std::span(off).last(state.count);
  if (const double error = error_of_departures(steady); std::isfinite(error)) state.mean.error = error;
  else if (!std::isfinite(state.mean.error) && state.count >= 12) state.mean = mean_of_blocks(steady, 6);
  return state;
}

double mean_of_last(const std::vector<double>& values, std::size_t count) {
  double sum = 0;
  for (std::size_t k = values.size() - count; k < values.size(); ++k) sum += values[k];
  return sum / static_cast<double>(count);
}

/// A stage that ends in equilibrium has the loads of its end, of which one sample tells no error; one that lasts a time
/// those of its steady part.
Numbers numbers_of(const Load& load, bool lasts, const std::string& unit) {
  const bool averaged = lasts && load.asked.size() >= 12;
  SteadyState off;
  if (averaged) off = departure(load);
  const double asked = averaged ? mean_of_last(load.asked, off.count) : load.asked.back();
  const double reached = averaged ? asked + off.mean.value : load.reached.back();
  const char* u = unit.c_str();
  Numbers j{{"asked_" + unit, described(asked, u, "Load asked for")}};
  j["reached_" + unit] = described({{"value", reached}, {"error", averaged ? off.mean.error : statistics::unknown}}, u,
                                   "Load reached: the contact forces on the side, mean where the stage lasts a time");
  if (averaged)
    j["spread_" + unit] = described(off.deviation, u, "Standard deviation of the load from what was asked for");
  const bool held = std::abs(reached - asked) <= largest_departure * std::abs(asked);
  j["held"] = described(held, "", "Whether the load reached is within 5 % of the one asked for");
  return j;
}

}  // namespace

template <int D> Numbers loads_of(const StageResultIn<D>& result, const dem::Stage& stage) {
  Numbers loads = Numbers::tree();
  for (int side = 0; side < sides_in<D>; ++side) {
    const Load load = load_of(result, stage, side);
    if (load.asked.empty()) continue;
    const bool lasts = stage.duration || stage.strain_cycles;
    loads[any_side_names[side]] = numbers_of(load, lasts, stage.side[side].kind == Kind::force ? "N" : "Pa");
  }
  if (loads.empty()) return loads;
  return {{"loads", std::move(loads)}};
}
template Numbers loads_of(const StageResult&, const dem::Stage&);
template Numbers loads_of(const SphereResult&, const dem::Stage&);

Numbers load_numbers(const StageEnd& end) { return loads_of(end.result, end.stage); }

}  // namespace arenite::fields
