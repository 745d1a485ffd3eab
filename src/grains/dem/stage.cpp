#include "grains/dem/stage.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/mapped.hpp"

namespace arenite::dem {

using Visitor = ParameterVisitor;

namespace {

bool is_ramped(const SideDrive& drive) { return drive.kind == SideDrive::Kind::force; }

std::int64_t ramp_increments(const Stage& stage) {
  return std::any_of(stage.side.begin(), stage.side.end(), is_ramped) ? std::max<std::int64_t>(1, stage.increments) : 1;
}

/// The sides' aims with a share (0 to 1) of the way from the start's forces done.
ByAnySide<SideDrive> on_the_ramp(const Stage& stage, const StageStart& start, double share) {
  ByAnySide<SideDrive> aims = stage.side;
  for (std::size_t side = 0; side < aims.size(); ++side)
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

constexpr std::int64_t usually_stored = 20;  // of many cycles, where nothing else is asked for

/// The first cycle is stored, and every so many, and the last.
template <class AnyCycles> bool is_stored(const AnyCycles& cycles, std::int64_t cycle) {
  return cycle <= 1 || cycle == cycles.count ||
         cycle % cycles.store_every.value_or((cycles.count + usually_stored - 1) / usually_stored) == 0;
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

bool moves_boundaries(const Stage& stage) {
  return std::ranges::any_of(stage.boundaries, &BoundaryMotion::moves) ||
         std::ranges::any_of(stage.boundaries_in_space, &BoundaryMotionIn<3>::moves);
}

bool moves_side(const Stage& stage, int side) {
  const Driven velocity{Driven::What::velocity, side};
  return stage.side[static_cast<std::size_t>(side)].kind == SideDrive::Kind::velocity ||
         std::ranges::any_of(stage.programmes, [&](const Programme& p) { return p.of == velocity; });
}

bool presses_by_two_membranes(const Stage& stage) {
  const auto both = [&](int a, int b) { return stage.side[a].is_skin() && stage.side[b].is_skin(); };
  return stage.skin.ends == SkinEnds::sliding && (both(left, right) || both(bottom, top));
}

bool strains_at_a_rate(const Stage& stage) {
  bool strains = stage.shear_rate != 0 || stage.slide != ByAnySide<double>{};
  for (int side = 0; side < sides_in<3>; ++side) strains |= moves_side(stage, side);
  return strains || std::ranges::any_of(stage.programmes, [](const Programme& p) {
           return p.of.is(Driven::What::slide) || p.of.is(Driven::What::shear_rate);
         });
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

template <int D> WallDrivesIn<D> drives_for(const Stage& stage, const Leg& leg, const DomainIn<D>& domain) {
  WallDrivesIn<D> drives;
  for (int side = 0; side < sides_in<D>; ++side) {
    const auto& [kind, value] = leg.side[side];
    switch (kind) {
      case SideDrive::Kind::fixed:
      case SideDrive::Kind::membrane: break;
      case SideDrive::Kind::velocity: drives[side] = {DriveKind::velocity, value * inward_sign(side)}; break;
      case SideDrive::Kind::force: drives[side] = {DriveKind::force, value}; break;
      case SideDrive::Kind::pressure: drives[side] = {DriveKind::force, thrust_on(domain, side, value)}; break;
    }
    if (domain.wall[side].present) drives[side].slide = way_along<D>(side, stage.slide[side]);
  }
  return drives;
}

template WallDrives drives_for<2>(const Stage&, const Leg&, const Domain&);
template WallDrivesIn<3> drives_for<3>(const Stage&, const Leg&, const DomainIn<3>&);

namespace {

/// Of cycles, how many have their states stored.
void declare_store_every(Visitor& v, std::optional<std::int64_t>& every) {
  static const std::string sentence = fmt::format(
      "States are stored every so many cycles, and for the first and the last; unless given, for about {} of them. "
      "Curves against cycles contain all.",
      usually_stored);
  v.integer({"store_every", sentence}, every, {1, 1'000'000});
}

}  // namespace

void EquilibriumCriterion::declare(Visitor& v) {
  v.number({"unbalanced", "Unbalanced force ratio below this."}, unbalanced, "", range::positive);
  v.number({"kinetic", "Kinetic over elastic energy below this."}, kinetic, "", range::positive);
  v.number(
      {"falling", "Fraction of grains that still fall (gravity, fewer than two compressive contacts) not above this."},
      falling, "", range::not_negative);
  static const std::string loose = fmt::format(
      "Kinetic energy of the grains that carry no load (fewer than two compressive contacts) over elastic energy below "
      "this; {} times `kinetic` unless given, because without gravity only rare collisions slow them.",
      loose_over_kinetic);
  v.number({"loose_kinetic", loose}, loose_kinetic, "", range::positive);
  v.number(
      {"mobilisation",
       "Mean |F_t|/F_n below this as well, if given: distinguishes creep from equilibrium where friction is viscous."},
      mobilisation, "", range::not_negative);
  v.integer({"max_steps", "Steps of one increment, after which the run stops with exit status 3."}, max_steps,
            {1, 1'000'000'000'000});
}

void Cycles::declare(Visitor& v) {
  v.choice({"side", "The side that cycles."}, side,
           {{"left", ""}, {"right", ""}, {"bottom", ""}, {"top", ""}, {"back", ""}, {"front", "of samples in space"}});
  std::optional<double> force[2], pressure[2];
  if (max > 0) (of_pressure ? pressure : force)[0] = min, (of_pressure ? pressure : force)[1] = max;
  v.number({"min", "Force at the end of each cycle."}, force[0], "kN", range::not_negative);
  v.number({"max", "Force in the middle of each cycle."}, force[1], "kN", range::positive);
  v.number({"min_pressure", "Pressure at the end of each cycle, where these are of pressure."}, pressure[0], "kPa",
           range::not_negative);
  v.number({"max_pressure", "Pressure in the middle of each cycle."}, pressure[1], "kPa", range::positive);
  const bool by_force = force[0] && force[1], by_pressure = pressure[0] && pressure[1];
  v.require(by_force != by_pressure && !(force[0] || force[1]) != !(pressure[0] || pressure[1]),
            {"max", "min", "max_pressure", "min_pressure"}, "give min and max, or min_pressure and max_pressure");
  of_pressure = by_pressure;
  min = (by_pressure ? pressure : force)[0].value_or(min), max = (by_pressure ? pressure : force)[1].value_or(max);
  v.require(max > min, {by_pressure ? "max_pressure" : "max", by_pressure ? "min_pressure" : "min"},
            by_pressure ? "must be above min_pressure" : "must be above min");
  v.integer({"count", "Number of cycles.", true}, count, {1, 1'000'000});
  v.integer({"increments", "Increments of each half cycle."}, increments, {1, 1'000'000});
  declare_store_every(v, store_every);
}

void StrainCycles::declare(Visitor& v) {
  v.choice({"of", "Quantity that cycles."}, of,
           {{"left", ""},
            {"right", ""},
            {"bottom", ""},
            {"top", "this side; strains are those of the sample normal to it, positive inward"},
            {"back", ""},
            {"front", "the same of samples in space"},
            {"shear", "a cell periodic in both directions, sheared back and forth"}});
  v.number({"min", "Strain at the end of each cycle."}, min, "", range::between(-0.9, 0.9));
  v.number({"max", "Strain in the middle of each cycle.", true}, max, "", range::between(-0.9, 0.9));
  v.require(max > min, {"max", "min"}, "must be above min");
  v.number({"rate", "Of strain.", true}, rate, "1/s", range::positive);
  v.integer({"count", "Number of cycles.", true}, count, {1, 1'000'000'000});
  declare_store_every(v, store_every);
}

void Programme::declare(Visitor& v) {
  auto chosen = static_cast<int>(target_of(of));
  v.choice({"of",
            "Driven quantity: a side's velocity (inward), force or pressure, the sliding of a wall, the shear rate, "
            "gravity, or a boundary: its position or angle relative to the start of the stage, its velocity or spin, "
            "or the force on it.",
            true},
           chosen, mapped(programme_targets, [](const auto& target) {
             return Word{target.word, ""};
           }));
  const auto& target = programme_targets[static_cast<std::size_t>(chosen)];
  of = target.of;
  v.when(of.is_of_boundary(), "of = \"boundary...\"", [&](Visitor& inner) {
    inner.text({"boundary", "Name of the boundary.", true}, name);
  });
  v.series(
      {"table",
       "Times from the beginning of the stage and values in the target's unit (mm, mm/s, N, kN, kPa, 1/s, m/s^2, deg "
       "or deg/s), with linear interpolation, constant before the first and after the last row; two rows with the same "
       "time are a jump. Or the name of a CSV file of these two columns with their units (`time [s],force [kN]`).",
       true},
      table, target.unit);
  v.flag({"repeat", "The table starts again after its last time, for cycles."}, repeat);
  const bool in_order = !table.empty() && table.front().x >= 0 && std::ranges::is_sorted(table, {}, &Vec2::x);
  v.require(in_order, {"table"}, "needs at least one row, with times from 0 s that never decrease");
  v.require(!repeat || (in_order && table.back().x > 0), {"repeat", "table"},
            "only a table with a duration can repeat");
  const bool may_be_negative = of.is(What::velocity) || !(of.is_of_side() || of.is(What::gravity_size));
  v.require(may_be_negative || std::ranges::all_of(
                                   table, [](double y) { return y >= 0; }, &Vec2::y),
            {"table"}, fmt::format("no value of {} may be below 0", target.word));
}

}  // namespace arenite::dem
