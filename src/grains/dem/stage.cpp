#include "grains/dem/stage.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace arenite::dem {
namespace {

bool is_ramped(const SideDrive& drive) { return drive.kind == SideDrive::Kind::force; }

std::int64_t ramp_increments(const Stage& stage) {
  return std::any_of(stage.side.begin(), stage.side.end(), is_ramped) ? std::max<std::int64_t>(1, stage.increments) : 1;
}

/// Increment `k` of the cycles, counted from 0.
Increment cycle_increment(const Stage& stage, double start, std::int64_t k) {
  const Cycles& cycles = *stage.cycles;
  const std::int64_t half = k / cycles.increments, step = k % cycles.increments + 1;
  const bool up = half % 2 == 0;
  const double from = half == 0 ? start : up ? cycles.min : cycles.max, to = up ? cycles.max : cycles.min;
  const double share = static_cast<double>(step) / static_cast<double>(cycles.increments);
  const std::string label = fmt::format("cycle {} {}", half / 2 + 1, up ? "maximum" : "minimum");
  Increment increment{stage.side, stage.slide, step == cycles.increments ? label : fmt::format("{}, {} of {}", label, step, cycles.increments)};
  increment.side[cycles.side] = {SideDrive::Kind::force, from + share * (to - from)};
  return increment;
}

}  // namespace

Increment on_the_ramp(const Stage& stage, const BySide<double>& force_at_start, double share, std::string label) {
  Increment increment{stage.side, stage.slide, std::move(label)};
  for (int side = 0; side < sides; ++side) {
    auto& drive = increment.side[side];
    if (is_ramped(drive)) drive.value = force_at_start[side] + share * (drive.value - force_at_start[side]);
  }
  return increment;
}

std::int64_t increment_count(const Stage& stage) {
  if (stage.strain_cycles) return 2 * stage.strain_cycles->count;
  return ramp_increments(stage) + (stage.cycles ? 2 * stage.cycles->count * stage.cycles->increments : 0);
}

Increment increment_at(const Stage& stage, const BySide<double>& force_at_start, std::int64_t k) {
  const std::int64_t n = ramp_increments(stage);
  if (k < n)
    return on_the_ramp(stage, force_at_start, static_cast<double>(k + 1) / static_cast<double>(n),
                       n == 1 ? std::string("equilibrium") : fmt::format("increment {} of {}", k + 1, n));
  const int side = stage.cycles->side;
  return cycle_increment(stage, is_ramped(stage.side[side]) ? stage.side[side].value : force_at_start[side], k - n);
}

CyclePlace cycle_place(const Stage& stage, std::int64_t k) {
  if (stage.strain_cycles) return {k / 2 + 1, true, k % 2 == 0};
  const std::int64_t ramp = ramp_increments(stage);
  if (!stage.cycles || k < ramp) return {};
  const std::int64_t half = (k - ramp) / stage.cycles->increments;
  return {half / 2 + 1, (k - ramp + 1) % stage.cycles->increments == 0, half % 2 == 0};
}

bool is_stored(const Stage& stage, const CyclePlace& place) {
  const auto every = stage.strain_cycles ? stage.strain_cycles->store_every : stage.cycles ? stage.cycles->store_every : std::nullopt;
  if (place.cycle <= 1 || !every) return true;
  return place.cycle % *every == 0 || place.cycle == (stage.strain_cycles ? stage.strain_cycles->count : stage.cycles->count);
}

StrainHalf strain_half(const StrainCycles& cycles, std::int64_t half, double time_step) {
  StrainHalf h;
  h.from = half == 0 ? 0 : half % 2 == 0 ? cycles.min : cycles.max;
  h.to = half % 2 == 0 ? cycles.max : cycles.min;
  h.steps = std::max<std::int64_t>(1, static_cast<std::int64_t>(std::ceil(std::abs(h.to - h.from) / (cycles.rate * time_step))));
  return h;
}

WallDrives drives_for(const Increment& increment, const Domain& domain) {
  WallDrives drives;
  for (int side = 0; side < sides; ++side) {
    const auto& drive = increment.side[side];
    switch (drive.kind) {
      case SideDrive::Kind::fixed: drives[side] = {WallDrive::Kind::fixed, 0}; break;
      case SideDrive::Kind::velocity: drives[side] = {WallDrive::Kind::velocity, drive.value * inward_sign(side)}; break;
      case SideDrive::Kind::force: drives[side] = {WallDrive::Kind::force, drive.value}; break;
      case SideDrive::Kind::pressure: drives[side] = {WallDrive::Kind::force, drive.value * domain.length(side) * domain.thickness}; break;
    }
    drives[side].slide = domain.wall[side].present ? increment.slide[side] : 0.0;
  }
  return drives;
}

std::vector<BoundaryDrive> boundary_drives_for(const Stage& stage, const Domain& domain) {
  std::vector<BoundaryDrive> drives;
  for (const Boundary& boundary : domain.boundaries) drives.push_back({{}, 0, mean_point(boundary.points), true});
  for (const BoundaryMotion& motion : stage.boundaries) {
    const std::size_t at = index_of(domain.boundaries, motion.name);
    if (at == domain.boundaries.size()) throw InputError(fmt::format("stage \"{}\" moves boundary \"{}\", which there is not", stage.name, motion.name));
    BoundaryDrive& drive = drives[at];
    drive = {motion.velocity, motion.spin, motion.centre.value_or(drive.centre), !motion.absent, motion.mass.value_or(0), motion.force};
  }
  return drives;
}

}  // namespace arenite::dem
