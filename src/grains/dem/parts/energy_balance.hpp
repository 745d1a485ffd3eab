#pragma once
#include <array>

#include "grains/dem/parts/forces_and_rates.hpp"
#include "grains/dem/parts/part.hpp"

namespace arenite::dem {

/// Work done on the sample in a step (J), or the power (W), by class of force.
struct WorkTerms {
  double dashpots = 0, friction = 0, drag = 0, gravity = 0, walls = 0, servo = 0;
};
constexpr double WorkTerms::*work_terms[] = {&WorkTerms::dashpots, &WorkTerms::friction, &WorkTerms::drag,
                                             &WorkTerms::gravity,  &WorkTerms::walls,    &WorkTerms::servo};

/// Account of dissipation and work, closed by the scheme's own identity where there is one. Under Verlet a step changes
/// sum m v^2/2 - (dt^2/8) m a^2 by exactly (F_n + F_n+1)/2 times the way made, so each class of force is given that
/// share of the work; of a linear spring that is the change of its energy, so what stays open is the second term (0 at
/// rest) and the steps in which a contact opens or closes. Under Gear the powers are integrated by the Adams-Moulton
/// rule of fourth order. What friction takes from the motion and its springs do not store is dissipated.
template <int D> struct EnergyBalanceIn : PartOf<D> {
  using S = SampleIn<D>;
  bool open = false;  ///< `last` belongs to the present state
  ForcesAndRates<D> last;
  std::array<WorkTerms, 3> powers{};  ///< Gear: now, one and two steps ago
  int known = 0;                      ///< how many of them are

  void break_step(S& /*sample*/) { open = false; }
  /// Takes the present state as the start of the next step, where drives, gravity or drag have changed.
  void begin(S& sample);
  /// Books the step that has just been made.
  void after_forces(S& sample);
  template <class Members> void transfer(S& /*sample*/, Members& members) {
    members(open, known);
    for (WorkTerms& power : powers)
      for (const auto term : work_terms) members(power.*term);
  }
  /// A snapshot of the same state has the same bits; Gear's powers are older.
  void go_on(S& sample);
};
using EnergyBalance = EnergyBalanceIn<2>;

}  // namespace arenite::dem
