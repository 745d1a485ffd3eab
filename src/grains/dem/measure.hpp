#pragma once
#include <cmath>
#include <type_traits>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Grains (velocities at the time of the positions), walls and contacts in the caller's order; contacts sorted by
/// (i, j).
template <int D> PackingIn<D> packing_of(const SampleIn<D>& sample);

/// Energies stored now, with the tally of what was dissipated and done so far, which is there only with track_energy.
template <int D> Energies energies_of(const SampleIn<D>& sample);

template <int D> Equilibrium equilibrium_of(const SampleIn<D>& sample);

/// Energy of the adhesion, J, <= 0.
template <int D> double adhesive_energy(const SampleIn<D>& sample);

/// How many grains, and what they weigh by density, radius and thickness, kg.
struct Amount {
  std::size_t grains = 0;
  double mass = 0;
};
/// Grains whose centre is below a height, m.
template <int D> Amount amount_below(const SampleIn<D>& sample, double height);

/// Length of a vector, with the last bit of std::hypot.
inline double hypotenuse(Vec2 f) { return std::hypot(f.x, f.y); }
inline double hypotenuse(Vec3 f) { return std::hypot(f.x, f.y, f.z); }

/// Changes something by decree, and books what an energy, a term of energies_of or a function of the sample, gains by
/// that as work of the sides or as exchanged, or what it loses as another `term` of the account.
template <int D, class Energy, class Change>
void book_change(SampleIn<D>& s, double Energies::*term, const Energy& energy, const Change& change) {
  if (!s.integration.track_energy) return change();
  const auto now = [&] {
    if constexpr (std::is_member_object_pointer_v<Energy>) return energies_of(s).*energy;
    else return energy(s);
  };
  const double before = now();
  change();
  const double gain = now() - before;
  s.tally.*term += term == &Energies::work_walls || term == &Energies::exchanged ? gain : -gain;
}

/// Gives a grain this place, angle and motion.
template <int D>
void put_grain(GrainsIn<D>& grains, std::size_t grain, Vec<D> place, Turning<D> angle, const Motion<D>& motion) {
  grains.position[grain] = place;
  grains.angle[grain] = angle;
  grains.velocity[grain] = motion.velocity;
  grains.omega[grain] = motion.omega;
}

}  // namespace arenite::dem
