#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "core/threads.hpp"
#include "grains/dem/engine.hpp"
#include "grains/dem/sample.hpp"

namespace arenite::dem {

/// Checks the input, sorts the disks, lists the contacts, chooses the step and evaluates the first forces. Throws InputError, every problem in one
/// pass, for input that makes no sense and for a step beyond the bounds.
Sample make_sample(const Packing& start, const ContactParameters& contact, const IntegrationParameters& integration);

/// The laws that the parameters ask for; `lead` and `lag` are those of Slip, s.
ContactLaws choose_laws(const ContactParameters& contact, double lead, double lag);

/// The laws as the integrator evaluates them from step to step: memories of friction know the step.
ContactLaws laws_between_steps(const Sample& sample);

/// Lists the contacts anew after something came or went; springs stay as they are. What springs hold of a body that is gone, or that came into the
/// grains, is work of the sides.
void list_anew(Sample& sample, const ThreadPool& pool);

/// Shortens a step that masses and bonds of now do not allow; InputError, with `what` they are, where it was given.
void allow_step(Sample& sample, const char* what);

/// Steps from now on are `dt`, s; the time made so far stays.
void change_step(Sample& sample, double dt);

/// Brings the integrated velocities (and Gear's places) to the present, so that a change of load acts from now on.
void synchronise(Sample& sample);

double time_of(const Sample& sample);  ///< since the start, s

/// Friction coefficients from the parameters, or `override_mu` at grains and walls alike; none where the law is none.
void apply_friction(Sample& sample, std::optional<double> override_mu);

/// Every bit that decides the future of a sample, beside its start and parameters. The list is not among them: it follows from where the disks were
/// when it was built, so that restoring lists the same slots in the same order.
std::vector<std::uint8_t> save_sample(const Sample& sample);

/// Throws InputError if the bytes are not a state of this sample (cut short, other grains, other step); the sample is then as it was.
void restore_sample(Sample& sample, const std::vector<std::uint8_t>& bytes);

/// What an engine is made of.
struct Engine::Machine {
  Sample sample;
  ThreadPool pool;
};

}  // namespace arenite::dem
