#pragma once
#include <cstddef>
#include <optional>
#include <vector>

#include "core/parameters.hpp"
#include "model/packing.hpp"
#include "statistics/estimate.hpp"

namespace arenite::fields {

/// What a state does not say of its contacts.
struct FrictionOptions {
  double friction = 0;
  std::optional<double> wall_friction;
  double tolerance = 1e-3;  ///< a contact slides where |F_t| is above (1 - tolerance) mu F_n
  int bins = 20;            ///< of the distribution
};
/// What is chosen by those who ask.
void declare(ParameterVisitor& visitor, FrictionOptions& options);

/// Friction at the contacts of one state. Without adhesion 0 <= mobilisation <= 1; where contacts are glued Coulomb's
/// cap is higher.
struct FrictionState {
  std::vector<double>
      mobilisation;              ///< of every contact, |F_t|/(mu F_n); NaN where it does not push or has no friction
  std::vector<double> power;     ///< of every contact, -F_t v_s, W; > 0 where it takes energy; NaN where v_s is unknown
  std::size_t contacts = 0;      ///< whose mobilisation is known, walls included
  statistics::Estimate mean;     ///< mobilisation
  statistics::Estimate sliding;  ///< share of contacts that slide
  statistics::Estimate sliding_grains;  ///< the same of contacts between grains only
  statistics::Curve density;            ///< of mobilisation from 0 to 1, larger ones in the last bin; error by counting
  std::size_t known_powers = 0;         ///< contacts whose sliding velocity is known
  double total_power = 0;               ///< W; NaN where no sliding velocity is known
  double sliding_power = 0;             ///< W, of contacts that slide: dissipated, while that of others may be stored
};

/// Measures them. Errors by leaving out blocks of the box, or single contacts where the box is not known. Throws
/// InputError for a friction coefficient below 0, a tolerance outside [0, 1), or no bins.
FrictionState measure_friction(const Packing& packing, const FrictionOptions& options);

}  // namespace arenite::fields
