#pragma once
#include <cstdint>
#include <optional>
#include <type_traits>
#include <vector>

#include "core/threads.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/movers.hpp"

namespace arenite::dem {

/// Checks the input, sorts the disks or spheres, lists the contacts, chooses the step and evaluates the first forces.
/// Throws InputError, every problem in one pass, for input that makes no sense and for a step beyond the bounds.
template <int D>
SampleIn<D> make_sample(const PackingIn<D>& start, const ContactParameters& contact,
                        const IntegrationParameters& integration, const KernelIn<D>& kernel);

/// Goes on by so many steps.
template <int D> void advance(SampleIn<D>& sample, const ThreadPool& pool, std::int64_t steps);

/// The laws that the parameters ask for; `lead` and `lag` are those of Slip, s.
ContactLaws choose_laws(const ContactParameters& contact, double lead, double lag);

/// The laws as the integrator evaluates them from step to step: memories of friction know the step.
template <int D> ContactLaws laws_between_steps(const SampleIn<D>& s) {
  const double lead = integrator_of(s).lead;
  return choose_laws(s.contact, lead * s.dt, (1.0 - lead) * s.dt);
}

/// Lists the contacts anew after something came or went; springs stay as they are. What springs hold of a body that is
/// gone, or that came into the grains, is work of the sides.
void list_anew(Sample& sample, const ThreadPool& pool);

/// Shortens a step that masses and bonds of now do not allow; InputError, with `what` they are, where it was given.
void allow_step(Sample& sample, const char* what);

/// Steps from now on are `dt`, s; the time made so far stays.
void change_step(Sample& sample, double dt);

/// Brings the integrated velocities (and Gear's places) to the present, so that a change of load acts from now on.
void synchronise(Sample& sample);

/// Since the start, s.
template <int D> double time_of(const SampleIn<D>& s) {
  return s.time_before + static_cast<double>(s.step - s.steps_before) * s.dt;
}

/// Friction coefficients from the parameters, or `override_mu` at grains and walls alike; none where the law is none.
template <int D> void apply_friction(SampleIn<D>& s, std::optional<double> override_mu) {
  s.friction = override_mu.value_or(s.contact.friction);
  s.wall_friction = override_mu.value_or(s.contact.wall_friction.value_or(s.contact.friction));
}

/// Every bit that decides the future of a sample, beside its start and parameters. The list is not among them: it
/// follows from where the disks were when it was built, so that restoring lists the same slots in the same order.
std::vector<std::uint8_t> save_sample(const Sample& sample);

/// Throws InputError if the bytes are not a state of this sample (cut short, other grains, other step); the sample is
/// then as it was.
void restore_sample(Sample& sample, const std::vector<std::uint8_t>& bytes);

/// Shortest contact time T_c = pi sqrt(m_eff/k) of any two grains of the sample (or a grain and a wall), those on bonds
/// included, s.
template <int D> double shortest_contact_time(const SampleIn<D>& sample);

/// Largest stable steps of the sample's integrator, from the stiffest and the most damped grain. A grain counts with
/// its contacts now or with six (spheres: twelve) of grains like itself, whichever is more, so that a loose sample may
/// be compacted.
template <int D> StepBounds step_bounds(const SampleIn<D>& sample);

/// Gives the disks their own masses, or even ones. Even: every grain is as heavy as makes its contacts as fast as those
/// of the grain whose contacts are fastest, k/m alike. The step stays stable, waves run through grains of unlike sizes
/// as fast as it allows, and equilibria do not change, for they do not know masses (but for weight: no gravity then).
/// Dashpots follow the masses, so restitution is kept. Speeds stay.
void give_masses(Sample& sample, MassScaling mass_scaling);

/// Makes all grains heavier alike, where masses are not their own, until the sample allows its time step: many grains
/// as fast as the fastest may together be faster than it is alone.
void make_heavy_enough(Sample& sample);

/// Grains (velocities at the time of the positions), walls and contacts in the caller's order.
template <int D> PackingIn<D> packing_of(const SampleIn<D>& sample);

/// Energies stored now, with the tally of what was dissipated and done so far.
template <int D> Energies energies_of(const SampleIn<D>& sample);

Equilibrium equilibrium_of(const Sample& sample);

/// Energy of the adhesion, J, <= 0.
template <int D> double adhesive_energy(const SampleIn<D>& sample);

/// Changes something by decree, and books what an energy, a term of energies_of or a function of the sample, gains by
/// that as work of the sides, or what it loses as another `term` of the account.
template <class Energy, class Change>
void book_change(Sample& s, double Energies::*term, const Energy& energy, const Change& change) {
  if (!s.integration.track_energy) return change();
  const auto now = [&] {
    if constexpr (std::is_member_object_pointer_v<Energy>) return energies_of(s).*energy;
    else return energy(s);
  };
  const double before = now();
  change();
  const double gain = now() - before;
  s.tally.*term += term == &Energies::work_walls ? gain : -gain;
}

/// What drives the walls where programmes do, and elsewhere as given: a force as it is now; a velocity stays, since it
/// is set step by step.
WallDrives under_programmes(const Sample& sample, WallDrives drives);

/// Shears a periodic cell at another rate from now on; grains are given the velocities of the change.
void change_shear_rate(Sample& sample, double rate);

/// Before a step: velocities of sides and boundaries and the rate of shear are those of its middle, so that the ways
/// made are the areas below the tables; boundaries whose place is given go there.
void follow_velocities(Sample& sample);

/// After the motion of a step: forces, pressures and gravity are those of its end.
void follow_loads(Sample& sample);

/// What an engine is made of.
struct Engine::Machine {
  Sample sample;
  ThreadPool pool;
};

}  // namespace arenite::dem
