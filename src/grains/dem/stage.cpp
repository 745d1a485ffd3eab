#include "grains/dem/stage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>

namespace arenite::dem {
namespace {

bool is_ramped(const SideDrive& drive) { return drive.kind == SideDrive::Kind::force; }

std::int64_t ramp_increments(const Stage& stage) {
  return std::any_of(stage.side.begin(), stage.side.end(), is_ramped) ? std::max<std::int64_t>(1, stage.increments) : 1;
}

/// The sides' aims with a share (0 to 1) of the way from the start's forces done.
BySide<SideDrive> on_the_ramp(const Stage& stage, const StageStart& start, double share) {
  BySide<SideDrive> aims = stage.side;
  for (int side = 0; side < sides; ++side)
    if (is_ramped(aims[side])) aims[side].value = start.force[side] + share * (aims[side].value - start.force[side]);
  return aims;
}

/// Puts a leg at the end of a half cycle, or within it.
void place_in_cycle(Leg& leg, std::int64_t half, bool ends_half) {
  leg.cycle = half / 2 + 1;
  leg.ends_half = ends_half;
  leg.at_maximum = half % 2 == 0;
  leg.label = fmt::format("cycle {} {}", leg.cycle, leg.at_maximum ? "maximum" : "minimum");
}

/// The first cycle is stored, and every so many, and the last.
template <class AnyCycles> bool is_stored(const AnyCycles& cycles, std::int64_t cycle) {
  constexpr std::int64_t stored = 20;  // of many cycles, where nothing else is asked for
  return cycle <= 1 || cycle == cycles.count ||
         cycle % cycles.store_every.value_or((cycles.count + stored - 1) / stored) == 0;
}

/// A ramp to rest.
void add_half_cycle(Leg& leg, const Stage& stage, const StageStart& start, std::int64_t k) {
  const Cycles& cycles = *stage.cycles;
  const std::int64_t half = k / cycles.increments, step = k % cycles.increments + 1;
  place_in_cycle(leg, half, step == cycles.increments);
  if (!leg.ends_half) leg.label = fmt::format("{}, {} of {}", leg.label, step, cycles.increments);
  const SideDrive& ramp = stage.side[cycles.side];
  const double first = ramp.kind == cycles.kind() ? ramp.value : start.force[cycles.side];
  const double from = half == 0        ? first
                      : leg.at_maximum ? cycles.min
                                       : cycles.max,
               to = leg.at_maximum ? cycles.max : cycles.min;
  const double share = static_cast<double>(step) / static_cast<double>(cycles.increments);
  leg.side = stage.side;
  leg.side[cycles.side] = {cycles.kind(), from + share * (to - from)};
  leg.stored = is_stored(cycles, leg.cycle);
}

/// The side goes on at the speed of its half cycle, or the cell is sheared at that rate.
void add_half_cycle_of_strain(Leg& leg, const StrainCycles& cycles, const StageStart& start, std::int64_t k,
                              double time_step) {
  const StrainHalf half = strain_half(cycles, k, time_step);
  const double rate = (half.to - half.from) / (static_cast<double>(half.steps) * time_step);
  place_in_cycle(leg, k, true);
  leg.until = half.steps;
  if (cycles.of == StrainCycles::shear) leg.shear_rate = rate;
  else leg.side[cycles.of] = {SideDrive::Kind::velocity, rate * start.size[cycles.of / 2]};
  leg.stored = is_stored(cycles, leg.cycle);
}

void add_time(Leg& leg, const Stage& stage, std::int64_t snapshot, double time_step) {
  const std::int64_t snapshots = std::max<std::int64_t>(1, stage.snapshots);
  leg.until = steps_of(*stage.duration, time_step) * (snapshot + 1) / snapshots;
  leg.label = snapshots == 1 ? std::string("end") : fmt::format("{} of {}", snapshot + 1, snapshots);
  leg.is_whole = false;
  leg.is_last = snapshot + 1 >= snapshots;
}

}  // namespace

std::size_t target_of(const Driven& driven) {
  return static_cast<std::size_t>(std::ranges::find(programme_targets, driven, &ProgrammeTarget::of) -
                                  programme_targets.begin());
}

std::int64_t steps_of(double duration, double time_step) {
  return static_cast<std::int64_t>(std::ceil(duration / time_step));
}

std::int64_t increment_count(const Stage& stage) {
  if (stage.strain_cycles) return 2 * stage.strain_cycles->count;
  return ramp_increments(stage) + (stage.cycles ? 2 * stage.cycles->count * stage.cycles->increments : 0);
}

StrainHalf strain_half(const StrainCycles& cycles, std::int64_t half, double time_step) {
  StrainHalf h;
  h.from = half == 0 ? 0 : half % 2 == 0 ? cycles.min : cycles.max;
  h.to = half % 2 == 0 ? cycles.max : cycles.min;
  h.steps = std::max<std::int64_t>(1, steps_of(std::abs(h.to - h.from), cycles.rate * time_step));
  return h;
}

Leg leg_at(const Stage& stage, const StageStart& start, std::int64_t k, std::int64_t snapshot, double time_step) {
  const bool timed = stage.strain_cycles || stage.duration;
  const std::int64_t ramp = ramp_increments(stage);
  Leg leg;
  leg.side = on_the_ramp(stage, start, timed ? 1 : static_cast<double>(k + 1) / static_cast<double>(ramp));
  leg.label = ramp == 1 ? std::string("equilibrium") : fmt::format("increment {} of {}", k + 1, ramp);
  leg.is_last = k + 1 == increment_count(stage);
  if (stage.strain_cycles) add_half_cycle_of_strain(leg, *stage.strain_cycles, start, k, time_step);
  else if (stage.duration) add_time(leg, stage, snapshot, time_step);
  else if (k >= ramp) add_half_cycle(leg, stage, start, k - ramp);
  return leg;
}

BySide<std::optional<double>> membrane_pressures(const Stage& stage) {
  BySide<std::optional<double>> pressures;
  for (int side = 0; side < sides; ++side)
    if (stage.side[side].is_skin()) pressures[side] = stage.side[side].value;
  return pressures;
}

WallDrives drives_for(const Stage& stage, const Leg& leg, const Domain& domain) {
  WallDrives drives;
  for (int side = 0; side < sides; ++side) {
    const auto& [kind, value] = leg.side[side];
    switch (kind) {
      case SideDrive::Kind::fixed:
      case SideDrive::Kind::membrane: break;
      case SideDrive::Kind::velocity: drives[side] = {WallDrive::Kind::velocity, value * inward_sign(side)}; break;
      case SideDrive::Kind::force: drives[side] = {WallDrive::Kind::force, value}; break;
      case SideDrive::Kind::pressure:
        drives[side] = {WallDrive::Kind::force, value * domain.length(side) * domain.thickness};
        break;
    }
    if (domain.wall[side].present) drives[side].slide = stage.slide[side];
  }
  return drives;
}

}  // namespace arenite::dem
