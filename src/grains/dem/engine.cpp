#include "grains/dem/engine.hpp"

#include <algorithm>
#include <cstdint>

#include "core/error.hpp"
#include "grains/dem/exchange/traffic.hpp"
#include "grains/dem/setup.hpp"

namespace arenite::dem {
namespace {

/// Threads that pay: two of them meet several times a step, which costs as much as some hundred disks.
int useful_threads(int asked, std::size_t disks) {
  constexpr std::size_t fewest_disks = 1000;
  return static_cast<int>(std::clamp<std::size_t>(disks / fewest_disks, 1, static_cast<std::size_t>(asked)));
}

template <int D> Vec<D> gravity_of(const Stage& stage) {
  return stage.gravity ? gravity_along<D>(stage.gravity_size, stage.gravity_angle) : Vec<D>{};
}

template <int D> double drag_of(const SampleIn<D>& sample, const Stage& stage) {
  return sample.integration.drag + stage.drag + stage.critical_drag * critical_drag(sample);
}

/// Walls that are taken away, those of membranes among them. One that is a membrane stays so: set_membranes says what
/// is wrong where it is not meant to.
ByAnySide<bool> open_in(const Sample& sample, const Stage& stage) {
  ByAnySide<bool> open = stage.open;
  for (int side = 0; side < sides; ++side)
    open[side] = open[side] || stage.side[side].is_skin() || sample.wall[side].skin;
  return open;
}

/// What a stage says of parts, as it begins and where it changes.
void begin_parts(SampleIn<3>& s, const Stage& stage, const ThreadPool& pool) {
  if (stage.bond) make_bonds(s, pool);
  set_open(s, stage.open, pool);
  set_boundaries<3>(s, stage.boundaries_in_space, pool);
  set_rough(s, stage.rough, pool);
}
void begin_parts(Sample& s, const Stage& stage, const ThreadPool& pool) {
  if (stage.bond) make_bonds(s, pool);
  set_open(s, open_in(s, stage), pool);
  set_boundaries(s, stage.boundaries, pool);
  set_membranes(s, membrane_pressures(stage), stage.skin, pool);
  set_rough(s, stage.rough, pool);
}

void change_parts(SampleIn<3>& s, const Stage& before, const Stage& after, const ThreadPool& pool) {
  if (after.boundaries_in_space != before.boundaries_in_space) set_boundaries<3>(s, after.boundaries_in_space, pool);
}
void change_parts(Sample& s, const Stage& before, const Stage& after, const ThreadPool& pool) {
  if (after.boundaries != before.boundaries) set_boundaries(s, after.boundaries, pool);
  if (membrane_pressures(after) != membrane_pressures(before))
    set_membranes(s, membrane_pressures(after), after.skin, pool);
}

void begin_traffic(SampleIn<3>& /*sample*/, const Exchange& /*exchange*/) {}
void begin_traffic(Sample& s, const Exchange& exchange) { begin_exchange(s, exchange); }
void let_pass(SampleIn<3>& /*sample*/, const Exchange& /*exchange*/, double /*since*/, const ThreadPool& /*pool*/) {}
void let_pass(Sample& s, const Exchange& exchange, double since, const ThreadPool& pool) {
  exchange_grains(s, exchange, since, pool);
}

}  // namespace

template <int D>
EngineIn<D>::EngineIn(const PackingIn<D>& given, const ContactParameters& parameters,
                      const IntegrationParameters& scheme)
    : SampleIn<D>(make_sample(given, parameters, scheme, find_kernel<D>(scheme.kernel))),
      pool_(std::make_unique<ThreadPool>(useful_threads(scheme.threads, given.grains.size()))) {}

template <int D> void EngineIn<D>::begin(const Stage& stage) {
  set_gravity(*this, gravity_of<D>(stage));
  set_friction(*this, stage.friction);
  if (stage.gravity && stage.mass_scaling == MassScaling::uniform)
    throw InputError("mass scaling cannot be used with gravity; leave gravity or mass_scaling out");
  set_mass_scaling(*this, stage.mass_scaling);
  set_inertial_number(*this, stage.inertial_number);
  set_drag(*this, drag_of(*this, stage));
  set_glue(*this, stage.glue);
  begin_parts(*this, stage, *pool_);
  set_shear_rate(*this, stage.shear_rate);
  set_programmes(*this, {stage.programmes, time_of(*this), stage.gravity_size, stage.gravity_angle});
  begin_traffic(*this, stage.exchange);
}

template <int D> void EngineIn<D>::change(const Stage& before, const Stage& after) {
  if (gravity_of<D>(after) != gravity_of<D>(before)) set_gravity(*this, gravity_of<D>(after));
  if (after.friction != before.friction) set_friction(*this, after.friction);
  if (after.drag != before.drag || after.critical_drag != before.critical_drag) set_drag(*this, drag_of(*this, after));
  change_parts(*this, before, after, *pool_);
  if (after.shear_rate != before.shear_rate) set_shear_rate(*this, after.shear_rate);
}

template <int D> void EngineIn<D>::advance(std::int64_t steps) { dem::advance<D>(*this, *pool_, steps); }

template <int D> void EngineIn<D>::exchange(const Exchange& exchange, double since) {
  let_pass(*this, exchange, since, *pool_);
}

template class EngineIn<2>;
template class EngineIn<3>;

}  // namespace arenite::dem
