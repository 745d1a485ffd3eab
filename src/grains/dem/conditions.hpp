#pragma once
#include <optional>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Brings the integrated velocities (and Gear's places) to the present, so that a change of load acts from now on.
template <int D> void synchronise(SampleIn<D>& sample);

template <int D> void set_gravity(SampleIn<D>& sample, Vec<D> g);  ///< m/s^2
template <int D> void set_drag(SampleIn<D>& sample, double rate);  ///< 1/s
/// For grains and walls; nullopt: what the parameters say.
template <int D> void set_friction(SampleIn<D>& sample, std::optional<double> mu);
/// Friction coefficients from the parameters, or `override_mu` at grains and walls alike; none where the law is none.
template <int D> void apply_friction(SampleIn<D>& s, std::optional<double> override_mu) {
  s.friction = override_mu.value_or(s.contact.friction);
  s.wall_friction = override_mu.value_or(s.contact.wall_friction.value_or(s.contact.friction));
}

/// Shears a cell that is periodic along x and y, du_x/dy, 1/s (Lees and Edwards 1972); grains are given the velocities
/// of the change at once.
template <int D> void set_shear_rate(SampleIn<D>& sample, double rate);
/// The same where the sample is known to be such a cell, and at the present.
template <int D> void change_shear_rate(SampleIn<D>& sample, double rate);

}  // namespace arenite::dem
