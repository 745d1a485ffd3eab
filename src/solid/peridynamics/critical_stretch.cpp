#include "solid/peridynamics/critical_stretch.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <variant>

#include "core/problems.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/space/bonds_in_space.hpp"

namespace arenite::peridynamics {
namespace {

/// The stretch that a toughness gives.
auto of_toughness(const DamageOptionsIn<2>& /*options*/, double dx) {
  return [=](const auto& law, double k, double e) { return law.critical_stretch(k, e, dx); };
}
auto of_toughness(const DamageOptionsIn<3>& options, double dx) {
  const auto half = space_half_bonds(options.horizon_in_space);
  const auto stiffness = bond_stiffness_in_space(options.horizon_in_space);
  double across = 0;
  for (std::size_t d = 0; d < half.size(); ++d) across += stiffness[d] * half[d].z * std::pow(half[d].square(), 2) / 2;
  return [=](const auto& law, double k, double e) { return law.critical_stretch_in_space(k, e, dx, across); };
}

}  // namespace

template <int D> std::array<double, 4> critical_stretches(const DamageOptionsIn<D>& o, double dx) {
  const Stiffness& e = o.stiffness;
  const Toughness& k = o.toughness;
  const Strength& f = o.strength;
  check_by_type("toughness", "Pa m^0.5", k.matrix, k.interface, k.particle);
  for (const double strength : {f.matrix, f.interface, f.particle})
    if (!(strength > 0)) throw refusal("a strength of bonds is {:g} Pa; give a positive one", strength);
  const auto tough = of_toughness(o, dx);
  return std::visit(
      [&](const auto& law) -> std::array<double, 4> {
        const auto lower = [&](double toughness, double strength, double modulus) {
          return std::min(tough(law, toughness, modulus), strength / modulus);
        };
        return {0, lower(k.matrix, f.matrix, e.matrix), lower(k.interface, f.interface, e.interface),
                lower(k.particle, f.particle, e.particle)};
      },
      o.law);
}

template std::array<double, 4> critical_stretches<2>(const DamageOptionsIn<2>&, double);
template std::array<double, 4> critical_stretches<3>(const DamageOptionsIn<3>&, double);

}  // namespace arenite::peridynamics
