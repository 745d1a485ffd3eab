#pragma once
#include <concepts>
#include <variant>

#include "solid/peridynamics/laws/elastic_brittle.hpp"

namespace arenite::peridynamics {

/// A bond law gives the force along a bond with its energy, so that a test can hold one against the other's gradient,
/// and tells when the bond breaks. A whole bond's force is proportional to its extension: the static solver and the
/// search for the next break rely on that. Young's modulus and toughness are those of the bond's type; keys of its own
/// it declares, and they stand beside `bond_law` in [[loads]].
template <class L>
concept BondLaw = requires(L choice, const L law, ParameterVisitor& visitor, double v) {
  { L::word } -> std::convertible_to<Word>;  // its name in recipes and what it is
  choice.declare(visitor);                   // its keys
  { law == law } -> std::convertible_to<bool>;
  { law.force(v, v) } -> std::same_as<double>;                // (extension, modulus); of the kernels' lanes too
  { law.energy(v, v) } -> std::same_as<double>;               // (extension, modulus)
  { law.resists_broken(v) } -> std::same_as<bool>;            // (extension): whether faces that have parted push
  { law.damage(v, v) } -> std::same_as<double>;               // (stretch, critical stretch), 1 at the break
  { law.critical_stretch(v, v, v) } -> std::same_as<double>;  // (toughness, Young modulus, dx)
  { law.critical_stretch_in_space(v, v, v, v) } -> std::same_as<double>;  // and the energy of bonds across a plane
};

/// The laws there are. A new one is a file beside these and a name here; the recipe's word, keys, documentation and
/// kernels for every instruction set follow, and the choice is visited once, outside the loops, so the law inlines into
/// them.
using BondLawChoice = std::variant<ElasticBrittle>;

template <class... L> constexpr bool all_bond_laws(std::variant<L...>*) { return (BondLaw<L> && ...); }
static_assert(all_bond_laws(static_cast<BondLawChoice*>(nullptr)));

}  // namespace arenite::peridynamics
