#include "model/elasticity/bounds.hpp"

#include <algorithm>

namespace arenite::elasticity {
namespace {

/// Moduli of the plane in plane stress: bulk E/(2(1 - nu)), shear E/(2(1 + nu)).
struct Moduli {
  double bulk, shear;
  double young() const { return bulk + shear > 0 ? 4 * bulk * shear / (bulk + shear) : 0; }
};

Moduli moduli_of(double young, double poisson) { return {young / (2 * (1 - poisson)), young / (2 * (1 + poisson))}; }

/// (sum of c_i/(m_i + around))^-1 - around, the mixture in a matrix that `around` stands for.
template <class Of> double mixed(const std::vector<Share>& phases, double around, Of of) {
  double sum = 0;
  for (const Share& phase : phases) {
    if (!(phase.area > 0)) continue;
    const double stiffness = of(phase) + around;
    if (!(stiffness > 0)) return 0;
    sum += phase.area / stiffness;
  }
  return 1 / sum - around;
}

double shtrikman(const std::vector<Share>& phases, double poisson, Moduli extreme) {
  const double turned = extreme.bulk + 2 * extreme.shear;
  const double around = turned > 0 ? extreme.shear * extreme.bulk / turned : 0;
  return Moduli{mixed(phases, extreme.shear, [&](const Share& p) { return moduli_of(p.young, poisson).bulk; }),
                mixed(phases, around, [&](const Share& p) { return moduli_of(p.young, poisson).shear; })}
      .young();
}

}  // namespace

ModulusBounds modulus_bounds(const std::vector<Share>& phases, double poisson) {
  ModulusBounds bounds;
  double least = -1, greatest = 0;
  for (const Share& phase : phases) {
    if (!(phase.area > 0)) continue;
    bounds.voigt += phase.area * phase.young;
    greatest = std::max(greatest, phase.young);
    least = least < 0 ? phase.young : std::min(least, phase.young);
  }
  bounds.reuss = mixed(phases, 0, [](const Share& phase) { return phase.young; });
  bounds.shtrikman_upper = shtrikman(phases, poisson, moduli_of(greatest, poisson));
  bounds.shtrikman_lower = shtrikman(phases, poisson, moduli_of(std::max(least, 0.0), poisson));
  return bounds;
}

namespace {

/// As `mixed`, by volumes.
template <class Of> double mixed_in_space(const std::vector<SpaceShare>& phases, double around, Of of) {
  double sum = 0;
  for (const SpaceShare& phase : phases) {
    if (!(phase.volume > 0)) continue;
    const double stiffness = of(phase) + around;
    if (!(stiffness > 0)) return 0;
    sum += phase.volume / stiffness;
  }
  return 1 / sum - around;
}

BulkAndShear mixed_around(const std::vector<SpaceShare>& phases, BulkAndShear extreme) {
  const double turned = extreme.bulk + 2 * extreme.shear;
  const double around = turned > 0 ? extreme.shear / 6 * (9 * extreme.bulk + 8 * extreme.shear) / turned : 0;
  return {mixed_in_space(phases, 4 * extreme.shear / 3, [](const SpaceShare& p) { return p.bulk; }),
          mixed_in_space(phases, around, [](const SpaceShare& p) { return p.shear; })};
}

}  // namespace

SpaceBounds space_bounds(const std::vector<SpaceShare>& phases) {
  SpaceBounds bounds;
  BulkAndShear least, greatest;
  bool first = true;
  for (const SpaceShare& phase : phases) {
    if (!(phase.volume > 0)) continue;
    bounds.voigt.bulk += phase.volume * phase.bulk;
    bounds.voigt.shear += phase.volume * phase.shear;
    greatest = {std::max(greatest.bulk, phase.bulk), std::max(greatest.shear, phase.shear)};
    least = first ? BulkAndShear{phase.bulk, phase.shear}
                  : BulkAndShear{std::min(least.bulk, phase.bulk), std::min(least.shear, phase.shear)};
    first = false;
  }
  bounds.reuss = {mixed_in_space(phases, 0, [](const SpaceShare& p) { return p.bulk; }),
                  mixed_in_space(phases, 0, [](const SpaceShare& p) { return p.shear; })};
  bounds.shtrikman_upper = mixed_around(phases, greatest);
  bounds.shtrikman_lower = mixed_around(phases, least);
  return bounds;
}

}  // namespace arenite::elasticity
