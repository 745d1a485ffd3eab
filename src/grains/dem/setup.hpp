#pragma once
#include <optional>

#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Checks the input, sorts the disks, lists the contacts, chooses the step and evaluates the first forces. Throws
/// InputError, every problem in one pass, for input that makes no sense and for a step beyond the bounds.
Sample make_sample(const Packing& start, const ContactParameters& contact, const IntegrationParameters& integration);

/// The laws as the integrator evaluates them from step to step: memories of friction know the step.
ContactLaws laws_between_steps(const Sample& sample);

/// Steps from now on are `dt`, s; the time made so far stays.
void change_step(Sample& sample, double dt);

double time_of(const Sample& sample);  ///< since the start, s

/// Friction coefficients from the parameters, or `override_mu` at grains and walls alike; none where the law is none.
void apply_friction(Sample& sample, std::optional<double> override_mu);

}  // namespace arenite::dem
