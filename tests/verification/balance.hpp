#pragma once
#include "model/result.hpp"

namespace arenite::verification {

/// What an account of energy lacks from one time to another, J.
inline double imbalance(const Energies& before, const Energies& after) {
  double sum = before.exchanged - after.exchanged;
  for (const EnergyTerm& term : energy_terms)
    sum += (term.role == EnergyRole::supplied ? -1 : 1) * (after.*term.value - before.*term.value);
  return sum;
}

}  // namespace arenite::verification
