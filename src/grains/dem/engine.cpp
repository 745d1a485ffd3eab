#include "grains/dem/engine.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "grains/dem/advance.hpp"
#include "grains/dem/glue.hpp"
#include "grains/dem/setup.hpp"

namespace arenite::dem {
namespace {

/// Threads that pay: two of them meet several times a step, which costs as much as some hundred disks.
int useful_threads(int asked, std::size_t disks) {
  constexpr std::size_t fewest_disks = 1000;
  return static_cast<int>(std::clamp<std::size_t>(disks / fewest_disks, 1, static_cast<std::size_t>(asked)));
}

}  // namespace

Engine::Engine(const Packing& given, const ContactParameters& parameters, const IntegrationParameters& scheme)
    : Sample(make_sample(given, parameters, scheme, find_kernel(scheme.kernel))),
      pool_(std::make_unique<ThreadPool>(useful_threads(scheme.threads, given.grains.size()))) {}

void Engine::begin(const Stage& stage) {
  const double g = stage.gravity ? stage.gravity_size : 0;
  set_gravity(*this, stage.gravity ? g * Vec2{std::sin(stage.gravity_angle), -std::cos(stage.gravity_angle)} : Vec2{});
  set_friction(*this, stage.friction);
  if (stage.gravity && stage.mass_scaling == MassScaling::uniform)
    throw InputError("mass scaling cannot be used with gravity; leave gravity or mass_scaling out");
  set_mass_scaling(*this, stage.mass_scaling);
  set_inertial_number(*this, stage.inertial_number);
  set_drag(*this, integration.drag + stage.drag + stage.critical_drag * critical_drag(*this));
  set_glue(*this, stage.glue);
  if (stage.bond) make_bonds(*this, *pool_);
  set_open(*this, stage.open, *pool_);
  set_boundaries(*this, stage.boundaries, *pool_);
  set_rough(*this, stage.rough, *pool_);
  set_shear_rate(*this, stage.shear_rate);
  set_programmes(*this, {stage.programmes, time_of(*this), stage.gravity_size, stage.gravity_angle});
}

void Engine::advance(std::int64_t steps) { dem::advance<2>(*this, *pool_, steps); }

}  // namespace arenite::dem
