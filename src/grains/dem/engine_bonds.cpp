#include "core/error.hpp"
#include "grains/dem/bonds.hpp"
#include "grains/dem/bounds.hpp"
#include "grains/dem/cohesion.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/setup.hpp"

namespace arenite::dem {

void Engine::make_bonds() {
  Sample& s = machine_->sample;
  if (!s.contact.has_bonds()) throw InputError("bonds cannot be made where contact.bonds is \"none\"");
  synchronise(s);
  list_anew(s, machine_->team);
  bond_near_pairs(s);
  list_anew(s, machine_->team);
  const double wanted = s.integration.safety * shortest_bond_time(s);
  if (!s.integration.time_step && wanted < s.dt) change_step(s, wanted);
  allow_step(s, "its bonds");
}

BondCount Engine::bond_count() const {
  const Sample& s = machine_->sample;
  BondCount count;
  for (const Bond& bond : s.bonds) {
    count.intact += bond.broken == BondBreak::none;
    count.in_tension += bond.broken == BondBreak::tension;
    count.in_bending += bond.broken == BondBreak::bending;
    count.in_shear += bond.broken == BondBreak::shear;
  }
  count.energy = bond_energy(s);
  return count;
}

bool Engine::is_cohesive() const { return machine_->sample.contact.is_cohesive(); }

CohesionCount Engine::cohesion_count() const {
  CohesionCount count;
  for (const CohesivePair& pair : cohesive_pairs(machine_->sample)) {
    ++count.joined;
    count.apart += pair.gap > 0;
  }
  return count;
}

}  // namespace arenite::dem
