#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/phase_map.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/failure_state.hpp"
#include "solid/peridynamics/options.hpp"

/// What a test of a bonded sample is told by.
namespace arenite::peridynamics {

/// Poisson's ratio of a plane lattice of central forces, whatever its bonds: in plane stress.
inline constexpr double lattice_poisson = 1.0 / 3;

/// How many of the broken bonds are of each BondType.
std::array<std::size_t, 4> broken_by_type(const std::vector<BrokenBond>& broken);

/// Of bonds that broke one after the other, by their types: how many of one type are broken after each step, up to
/// which so many of any type are.
std::vector<double> broken_after_steps(const std::vector<std::uint8_t>& types, const std::vector<double>& of_any_type,
                                       int type);

/// Strain at which the stress was largest, the last if it was so more than once; nothing where nothing carried.
std::optional<double> strain_at_strength(const FailureRecord& test);

/// What sets the stretch at which a bond breaks.
enum class Limit { toughness, strength };

/// By BondType, on a grid of one spacing: the stretch at which bonds break, and what sets it.
struct BreakingLimits {
  std::array<double, 4> stretch{};
  std::array<Limit, 4> set_by{};
  /// Whether that of bonds of the cement, along which a sample parts, follows from toughness: it then grows as the
  /// spacing to the power -1/2, and the sample's strength with it.
  bool follow_spacing() const {
    return set_by[matrix_bond] == Limit::toughness || set_by[interface_bond] == Limit::toughness;
  }
};

/// Throws InputError as `critical_stretches`.
template <int D> BreakingLimits breaking_limits(const DamageOptionsIn<D>& options, double dx);

/// Whether the lower and the upper edge of a map are joined by bonds through voids alone, by no solid.
bool joined_through_voids_only(const PhaseMap& map);

}  // namespace arenite::peridynamics
