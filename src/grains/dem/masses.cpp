#include "grains/dem/masses.hpp"

#include <algorithm>

#include "grains/dem/conditions.hpp"
#include "grains/dem/glue.hpp"
#include "grains/dem/integrators/time_step.hpp"
#include "grains/dem/measure.hpp"
#include "grains/dem/walls.hpp"

namespace arenite::dem {

namespace {

/// Dashpots of the listed contacts, from the present masses.
template <int D> void renew_dashpots(SampleIn<D>& s) {
  ContactListIn<D>& list = s.list;
  for (std::size_t p = 0; p < list.size(); ++p) {
    const GrainRecord<D>& a = s.record[list.i[p]];
    const Coefficients c = list.j[p] < 0 ? s.coefficients.wall(a) : pair_coefficients(s, a, s.record[list.owner[p]]);
    list.damping[p] = c.damping;
    list.viscosity[p] = c.viscosity;
  }
  each_part(s, [&](auto& part) { part.renew_dashpots(s); });
}

/// Gives the disks their own masses, or even ones. Even: every grain is as heavy as makes its contacts as fast as those
/// of the grain whose contacts are fastest, k/m alike. The step stays stable, waves run through grains of unlike sizes
/// as fast as it allows, and equilibria do not change, for they do not know masses (but for weight: no gravity then).
/// Dashpots follow the masses, so restitution is kept. Speeds stay.
template <int D> void give_masses(SampleIn<D>& s, MassScaling masses) {
  s.mass_scaling = masses;
  double fastest = 0;
  for (std::size_t k = 0; k < s.count; ++k) {
    s.record[k].mass = own_mass(s, s.record[k].grain);
    fastest = std::max(fastest, s.coefficients.pair_stiffness(s.record[k], s.record[k]) / s.record[k].mass);
  }
  if (masses == MassScaling::uniform)
    for (std::size_t k = 0; k < s.count; ++k)
      s.record[k].mass = s.coefficients.pair_stiffness(s.record[k], s.record[k]) / fastest;
  each_part(s, [&](auto& part) { part.take_masses(s); });
  renew_dashpots(s);
  tune_servo(s);
}

/// Makes all grains heavier alike, where masses are not their own, until the sample allows its time step: many grains
/// as fast as the fastest may together be faster than it is alone.
template <int D> void make_heavy_enough(SampleIn<D>& s) {
  if (s.mass_scaling != MassScaling::uniform) return;
  constexpr int rounds = 10;  // one does, unless drag counts: the longest step grows as the root of the mass
  for (int round = 0; round < rounds; ++round) {
    const double short_by = s.dt / step_bounds(s).largest();
    if (short_by <= 1) return;
    for (std::size_t k = 0; k < s.count; ++k) s.record[k].mass *= 1.002 * short_by * short_by;
    each_part(s, [&](auto& part) { part.take_masses(s); });
    renew_dashpots(s);
    tune_servo(s);
  }
}

}  // namespace

template <int D> void set_mass_scaling(SampleIn<D>& s, MassScaling masses) {
  if (masses == s.mass_scaling) return;
  synchronise(s);
  book_change(s, &Energies::dissipated_drag, &Energies::kinetic, [&] {
    give_masses(s, masses);
    make_heavy_enough(s);
    allow_step(s, masses == MassScaling::uniform ? "scaled masses" : "its own masses");
  });
}

template void set_mass_scaling(Sample&, MassScaling);
template void set_mass_scaling(SampleIn<3>&, MassScaling);

}  // namespace arenite::dem
