#include "grains/dem/integrators/time_step.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace arenite::dem {

ContactLaws choose_laws(const ContactParameters& contact, double lead, double lag) {
  return {contact.normal,
          contact.adhesion,
          contact.friction_law,
          lead,
          lag,
          contact.tangential_stiffness_ratio,
          contact.friction_cap == FrictionCap::raised_by_adhesion ? 1.0 : -1.0,
          contact.normal_damping.has_value(),
          contact.normal_damping.has_value() || contact.sliding_viscosity.has_value()};
}

template <int D> void change_step(SampleIn<D>& s, double dt) {
  s.time_before = time_of(s);
  s.steps_before = s.step;
  s.dt = dt;
  s.laws = laws_between_steps(s);
}

template <int D> void allow_step(SampleIn<D>& s, const char* what) {
  const double largest = step_bounds(s).largest();
  if (!(s.dt > largest)) return;
  if (s.integration.time_step)
    throw InputError(
        fmt::format("integration.time_step of {:.4g} s is beyond what this sample allows with {}; use {:.4g} s", s.dt,
                    what, 0.999 * largest));
  change_step(s, 0.999 * largest);
}

template <int D> void choose_step(SampleIn<D>& s) {
  const StepBounds bounds = step_bounds(s);
  const auto& asked = s.integration.time_step;
  s.dt = asked.value_or(std::min(s.integration.safety * shortest_contact_time(s), bounds.largest()));
  if (!(std::isfinite(s.dt) && s.dt > 0)) throw InputError(fmt::format("time step {} s must be above 0", s.dt));
  if (s.dt > bounds.largest())
    throw InputError(fmt::format(
        "integration.time_step of {:.4g} s is too long for this packing: {} would make it unstable; use {:.4g} s, or "
        "leave the key out",
        s.dt, bounds.damping < bounds.stiffness ? "damping (dashpots and drag)" : "the stiffness of its contacts",
        0.999 * bounds.largest()));
  s.dt_at_start = s.dt;
}

template void change_step(Sample&, double);
template void change_step(SampleIn<3>&, double);
template void allow_step(Sample&, const char*);
template void allow_step(SampleIn<3>&, const char*);
template void choose_step(SampleIn<2>&);
template void choose_step(SampleIn<3>&);

}  // namespace arenite::dem
