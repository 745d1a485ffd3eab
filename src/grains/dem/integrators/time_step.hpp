#pragma once
#include "grains/dem/bounds.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

template <int D> inline const Integrator& integrator_of(const SampleIn<D>& s) {
  return integrator_of(s.integration.integrator);
}

/// The laws that the parameters ask for; `lead` and `lag` are those of Slip, s.
ContactLaws choose_laws(const ContactParameters& contact, double lead, double lag);

/// The laws as the integrator evaluates them from step to step: memories of friction know the step.
template <int D> ContactLaws laws_between_steps(const SampleIn<D>& s) {
  const double lead = integrator_of(s).lead;
  return choose_laws(s.contact, lead * s.dt, (1.0 - lead) * s.dt);
}

/// The step of a new sample: as given, or as its contacts allow. InputError for one beyond the bounds.
template <int D> void choose_step(SampleIn<D>& sample);

/// Shortens a step that masses and bonds of now do not allow; InputError, with `what` they are, where it was given.
template <int D> void allow_step(SampleIn<D>& sample, const char* what);

/// Steps from now on are `dt`, s; the time made so far stays.
template <int D> void change_step(SampleIn<D>& sample, double dt);

}  // namespace arenite::dem
