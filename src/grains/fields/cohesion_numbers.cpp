#include "grains/fields/stage_numbers.hpp"

#include <algorithm>
#include <numbers>
#include <string>
#include <vector>

#include "statistics/measured.hpp"

namespace arenite::fields {
namespace {

/// Mean pull of the joined pairs that touch; 0 where none does.
double pull_at_contact(const Packing& packing) {
  std::vector<double> pulls;
  for (const CohesivePair& pair : packing.cohesive)
    if (!acts_across_gap(pair)) pulls.push_back(pair.pull);
  return pulls.empty() ? 0 : statistics::mean_of(pulls).value;
}

/// Mean pressure on the right and the upper side, Pa.
double pressure_on(const Domain& domain) {
  return 0.5 * (domain.wall[right].force / domain.height() + domain.wall[top].force / domain.width()) /
         domain.thickness;
}

/// Largest tension on a side that moves outward, Pa; 0 where none does.
double tensile_strength(const StageResult& result, const dem::Stage& stage, double thickness) {
  double strength = 0;
  for (int side = 0; side < sides; ++side) {
    if (stage.side[side].kind != dem::SideDrive::Kind::velocity || !(stage.side[side].value < 0)) continue;
    const History& history = result.history;
    const int beside = side < bottom ? bottom : left;  // with the next one the ends of the side
    const auto *force = history.find(std::string(side_names[side]) + "_force"),
               *from = history.find(std::string(side_names[beside]) + "_position"),
               *to = history.find(std::string(side_names[beside + 1]) + "_position");
    if (!force || !from || !to) continue;
    for (std::size_t k = 0; k < force->size(); ++k)
      strength = std::max(strength, -(*force)[k] / (((*to)[k] - (*from)[k]) * thickness));
  }
  return strength;
}

}  // namespace

Numbers cohesion_numbers(const StageEnd& of) {
  const auto& [result, stage, before, texture, options] = of;
  const Packing& end = result.snapshots.back().packing;
  const Packing& start = before ? *before : end;
  if (end.cohesive.empty() && start.cohesive.empty()) return Numbers::tree();
  using statistics::described;
  Numbers j{{"pairs", described(end.cohesive.size(), "", "Pairs of grains that cohere")},
            {"pairs_apart", described(std::count_if(end.cohesive.begin(), end.cohesive.end(), acts_across_gap), "",
                                      "Of these, pairs that do not touch")}};
  const double pull = pull_at_contact(start), thickness = end.domain.thickness;
  if (!(pull > 0)) return {{"cohesion", j}};
  const double diameter = start.grains.mean_diameter(), grains = static_cast<double>(start.grains.size());
  const double load =
      stage.gravity ? mass_of(start) / grains * stage.gravity_size : pressure_on(start.domain) * diameter * thickness;
  j["pull_N"] = described(pull, "N", "Mean attraction of a pair in contact");
  if (load > 0)
    j["bond_number"] = described(pull / load, "", "Granular Bond number: this attraction over the load on a grain");
  if (const double strength = tensile_strength(result, stage, thickness); before && strength > 0) {
    const double fraction = start.grains.area() / start.domain.area(),
                 neighbours = 2.0 * static_cast<double>(start.cohesive.size()) / grains;
    j["tensile_strength_Pa"] = described(strength, "Pa", "Largest tension on a side that moves outward");
    const double rumpf = fraction * neighbours * pull / (std::numbers::pi * diameter * thickness),
                 pressure = pressure_on(start.domain);
    j["rumpf_Pa"] = described(rumpf, "Pa", "Rumpf's estimate of the tensile strength");
    if (!(pressure > 0)) return {{"cohesion", j}};
    j["tensile_strength_over_pressure"] =
        described(strength / pressure, "", "Tensile strength over the pressure before");
    j["rumpf_over_pressure"] = described(rumpf / pressure, "", "Rumpf's estimate over the pressure before");
  }
  return {{"cohesion", j}};
}

}  // namespace arenite::fields
