#pragma once
#include <optional>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Brings the integrated velocities (and Gear's places) to the present, so that a change of load acts from now on.
void synchronise(Sample& sample);

void set_gravity(Sample& sample, Vec2 g);    ///< m/s^2
void set_drag(Sample& sample, double rate);  ///< 1/s
/// For grains and walls; nullopt: what the parameters say.
void set_friction(Sample& sample, std::optional<double> mu);
/// Friction coefficients from the parameters, or `override_mu` at grains and walls alike; none where the law is none.
template <int D> void apply_friction(SampleIn<D>& s, std::optional<double> override_mu) {
  s.friction = override_mu.value_or(s.contact.friction);
  s.wall_friction = override_mu.value_or(s.contact.wall_friction.value_or(s.contact.friction));
}

/// Shears a cell that is periodic both ways, du_x/dy, 1/s (Lees and Edwards 1972); grains are given the velocities of
/// the change at once.
void set_shear_rate(Sample& sample, double rate);
/// The same where the sample is known to be such a cell, and at the present.
void change_shear_rate(Sample& sample, double rate);

}  // namespace arenite::dem
