#pragma once
#include <cstdint>
#include <map>
#include <utility>

#include "grains/fields/loading.hpp"

namespace arenite::fields {

/// Of the stored states of a stage, disks or spheres: `solid_fraction` (away from the walls), `z`,
/// `z_without_rattlers`, `rattlers`, `a_c` (and signed by the axis of loading: all, strong, weak contacts), `a_n`,
/// `a_t`, `theta_c`, `mean_force`, `strong_share`, `p`, `q`, `q_on_strong`, `q_over_p`, with their errors; NaN where a
/// state has no such number.
template <int D> statistics::Columns numbers_of_states(const StageResultIn<D>& stage);

/// Curves over the stored states of a test: its strains and those numbers.
statistics::Columns curves_of_states(const Test& test);

/// The same of a stage of spheres that is compressed along one axis or sheared: `time`, its strains
/// (curves_in_space.hpp) and those numbers. Throws InputError for another.
statistics::Columns states_in_space(const SphereResult& stage);

/// Places of the states at the largest and at the smallest load of every cycle that is whole, by its number.
std::map<std::int64_t, std::pair<std::size_t, std::size_t>> whole_cycles(const StageResult& stage);

/// Every curve over the states at the largest and the smallest load of each cycle: `cycle`, `axial_strain_maximum`,
/// `z_minimum`; `strain_amplitude` between the two; `accumulated_strain` at the smallest since the end of the first;
/// `dissipated_energy` in each cycle. Throws InputError where no states of a whole cycle are stored.
statistics::Columns curves_of_cycles(const Test& test);

/// The curves of a test with cycles at the largest and the smallest load or strain of every cycle: `cycle`,
/// `axial_strain_maximum`, `mu_minimum`; `accumulated_strain` at the smallest since the end of the first. Throws
/// InputError where there is no whole cycle.
statistics::Columns every_cycle(const Test& test);

}  // namespace arenite::fields
