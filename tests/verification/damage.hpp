#pragma once
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/lattice.hpp"
#include "solid/peridynamics/load.hpp"
#include "support/cemented_sample.hpp"
#include "support/crack_energy.hpp"
#include "support/homogeneous_sample.hpp"
#include "support/lattice_moduli.hpp"

namespace arenite::peridynamics {

/// Toughness that breaks bonds at strains where the linearised stretch holds.
inline constexpr Toughness weak{1e-5, 1e-5, 3.5e-5};

inline DamageOptions of_weak_bonds(Loading loading = Loading::tension, int max_events = 10'000) {
  DamageOptions options;
  options.toughness = weak;
  options.loading = loading;
  options.max_events = max_events;
  return options;
}

}  // namespace arenite::peridynamics
