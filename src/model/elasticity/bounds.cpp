#include "model/elasticity/bounds.hpp"

#include <algorithm>

namespace arenite::elasticity {
namespace {

/// (sum of c_i/(m_i + around))^-1 - around, the mixture in a matrix that `around` stands for.
template <int D, class Of> double mixed(const std::vector<PhaseShare<D>>& phases, double around, Of of) {
  double sum = 0;
  for (const PhaseShare<D>& phase : phases) {
    if (!(phase.share > 0)) continue;
    const double stiffness = of(phase.moduli) + around;
    if (!(stiffness > 0)) return 0;
    sum += phase.share / stiffness;
  }
  return 1 / sum - around;
}

template <int D> double bulk_of(const BulkAndShear<D>& m) { return m.bulk; }
template <int D> double shear_of(const BulkAndShear<D>& m) { return m.shear; }

/// Hashin and Shtrikman's bound from the extreme moduli.
template <int D> BulkAndShear<D> shtrikman(const std::vector<PhaseShare<D>>& phases, BulkAndShear<D> extreme) {
  const auto [bulk, shear] = extreme;
  const double turned = bulk + 2 * shear;
  const double around = turned > 0 ? shear * (D * bulk / 2 + (D + 1) * (D - 2) * shear / D) / turned : 0;
  return {mixed(phases, 2.0 * (D - 1) / D * shear, bulk_of<D>), mixed(phases, around, shear_of<D>)};
}

/// That of all solid phases; nothing where they differ.
std::optional<double> one_poisson(const std::vector<Share>& phases) {
  std::optional<double> one;
  for (const Share& phase : phases) {
    if (!(phase.young > 0)) continue;
    if (one && *one != phase.poisson) return std::nullopt;
    one = phase.poisson;
  }
  return one.value_or(0);  // of voids alone any
}

}  // namespace

template <int D> BoundsIn<D> bounds(const std::vector<PhaseShare<D>>& phases) {
  BoundsIn<D> bounds;
  BulkAndShear<D> least, greatest;
  bool first = true;
  for (const auto& [share, moduli] : phases) {
    if (!(share > 0)) continue;
    bounds.voigt.bulk += share * moduli.bulk;
    bounds.voigt.shear += share * moduli.shear;
    greatest = {std::max(greatest.bulk, moduli.bulk), std::max(greatest.shear, moduli.shear)};
    least = first ? moduli : BulkAndShear<D>{std::min(least.bulk, moduli.bulk), std::min(least.shear, moduli.shear)};
    first = false;
  }
  bounds.reuss = {mixed(phases, 0, bulk_of<D>), mixed(phases, 0, shear_of<D>)};
  bounds.shtrikman_upper = shtrikman(phases, greatest);
  bounds.shtrikman_lower = shtrikman(phases, least);
  return bounds;
}

template BoundsIn<2> bounds(const std::vector<PhaseShare<2>>& phases);
template BoundsIn<3> bounds(const std::vector<PhaseShare<3>>& phases);

std::optional<ModulusBounds> modulus_bounds(const std::vector<Share>& phases) {
  const auto poisson = one_poisson(phases);
  if (!poisson) return std::nullopt;
  std::vector<PhaseShare<2>> shares;
  for (const Share& phase : phases)
    shares.push_back({phase.area, {phase.young / (2 * (1 - *poisson)), phase.young / (2 * (1 + *poisson))}});
  const BoundsIn<2> all = bounds(shares);
  return ModulusBounds{all.voigt.young(), all.reuss.young(), all.shtrikman_upper.young(), all.shtrikman_lower.young()};
}

}  // namespace arenite::elasticity
