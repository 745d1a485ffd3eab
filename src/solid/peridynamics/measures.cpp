#include "solid/peridynamics/measures.hpp"

#include "solid/grid/cavities.hpp"
#include "solid/peridynamics/critical_stretch.hpp"

namespace arenite::peridynamics {

std::array<std::size_t, 4> broken_by_type(const std::vector<BrokenBond>& broken) {
  std::array<std::size_t, 4> count{};
  for (const BrokenBond& bond : broken) ++count[bond.type & 3u];
  return count;
}

std::vector<double> broken_after_steps(const std::vector<std::uint8_t>& types, const std::vector<double>& of_any_type,
                                       int type) {
  std::vector<double> broken;
  std::size_t k = 0;
  double count = 0;
  for (const double until : of_any_type) {
    for (; k < types.size() && static_cast<double>(k) < until; ++k) count += types[k] == type ? 1 : 0;
    broken.push_back(count);
  }
  return broken;
}

std::optional<double> strain_at_strength(const FailureRecord& test) {
  std::optional<double> strain;
  for (const DamageState& state : test.curve)
    if (state.stress == test.strength) strain = state.strain;
  return strain;
}

template <int D> BreakingLimits breaking_limits(const DamageOptionsIn<D>& options, double dx) {
  DamageOptionsIn<D> tough_alone = options;
  tough_alone.strength = {};
  const auto of_toughness = critical_stretches(tough_alone, dx);
  BreakingLimits limits{critical_stretches(options, dx), {}};
  for (std::size_t type = 0; type < of_toughness.size(); ++type)
    if (limits.stretch[type] < of_toughness[type]) limits.set_by[type] = Limit::strength;
  return limits;
}
template BreakingLimits breaking_limits(const DamageOptionsIn<2>&, double);
template BreakingLimits breaking_limits(const DamageOptionsIn<3>&, double);

bool joined_through_voids_only(const PhaseMap& map) {
  // What bonds join that stop at voids is joined side by side: solid where voids go through corners.
  return bonds_across_voids(map) > 0 && !grid::find_percolation(map, true).solid_bottom_top;
}

}  // namespace arenite::peridynamics
