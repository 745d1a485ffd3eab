#include "grains/dem/stage.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace arenite::dem {
namespace {

bool is_ramped(const SideDrive& drive) { return drive.kind == SideDrive::Kind::force; }

int side_index(const std::string& name) {
  for (int side = 0; side < 4; ++side)
    if (name == side_names[side]) return side;
  return bottom;
}

/// Length of sample that a side's pressure acts on, m.
double loaded_length(const Domain& domain, int side) { return side < 2 ? domain.height() : domain.width(); }

void add_half_cycle(std::vector<Increment>& increments, const Stage& stage, const Cycles& cycles, double from, double to, const std::string& label) {
  for (std::int64_t k = 1; k <= cycles.increments; ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(cycles.increments);
    Increment increment{stage.side, stage.slide, k == cycles.increments ? label : fmt::format("{}, {} of {}", label, k, cycles.increments)};
    increment.side[side_index(cycles.side)] = {SideDrive::Kind::force, from + share * (to - from)};
    increments.push_back(std::move(increment));
  }
}

}  // namespace

Increment on_the_ramp(const Stage& stage, const std::array<double, 4>& force_at_start, double share, std::string label) {
  Increment increment{stage.side, stage.slide, std::move(label)};
  for (int side = 0; side < 4; ++side) {
    auto& drive = increment.side[side];
    if (is_ramped(drive)) drive.value = force_at_start[side] + share * (drive.value - force_at_start[side]);
  }
  return increment;
}

std::vector<Increment> increments_of(const Stage& stage, const std::array<double, 4>& force_at_start) {
  std::vector<Increment> increments;
  const bool ramps = std::any_of(stage.side.begin(), stage.side.end(), is_ramped);
  const std::int64_t n = ramps ? std::max<std::int64_t>(1, stage.increments) : 1;
  for (std::int64_t k = 1; k <= n; ++k)
    increments.push_back(on_the_ramp(stage, force_at_start, static_cast<double>(k) / static_cast<double>(n),
                                     n == 1 ? std::string("rest") : fmt::format("increment {} of {}", k, n)));
  if (!stage.cycles) return increments;
  const auto& cycles = *stage.cycles;
  const auto& driven = stage.side[side_index(cycles.side)];
  double from = driven.kind == SideDrive::Kind::force ? driven.value : force_at_start[side_index(cycles.side)];
  for (std::int64_t c = 1; c <= cycles.count; ++c)
    for (const auto& [aim, name] : {std::pair{cycles.max, "maximum"}, std::pair{cycles.min, "minimum"}}) {
      add_half_cycle(increments, stage, cycles, from, aim, fmt::format("cycle {} {}", c, name));
      from = aim;
    }
  return increments;
}

WallDrives drives_for(const Increment& increment, const Domain& domain) {
  WallDrives drives;
  for (int side = 0; side < 4; ++side) {
    const auto& drive = increment.side[side];
    const Vec2 inward = inward_normal(side);
    switch (drive.kind) {
      case SideDrive::Kind::fixed: drives[side] = {WallDrive::Kind::fixed, 0}; break;
      case SideDrive::Kind::velocity: drives[side] = {WallDrive::Kind::velocity, drive.value * (inward.x + inward.y)}; break;
      case SideDrive::Kind::force: drives[side] = {WallDrive::Kind::force, drive.value}; break;
      case SideDrive::Kind::pressure: drives[side] = {WallDrive::Kind::force, drive.value * loaded_length(domain, side) * domain.thickness}; break;
    }
    drives[side].slide = domain.wall[side].present ? increment.slide[side] : 0.0;
  }
  return drives;
}

std::vector<BoundaryDrive> boundary_drives_for(const Stage& stage, const Domain& domain) {
  std::vector<BoundaryDrive> drives;
  for (const Boundary& boundary : domain.boundaries) drives.push_back({{}, 0, mean_point(boundary.points), true});
  for (const BoundaryMotion& motion : stage.boundaries) {
    const auto at = std::find_if(domain.boundaries.begin(), domain.boundaries.end(), [&](const Boundary& b) { return b.name == motion.name; });
    if (at == domain.boundaries.end()) throw InputError(fmt::format("stage \"{}\" moves boundary \"{}\", which there is not", stage.name, motion.name));
    BoundaryDrive& drive = drives[static_cast<std::size_t>(at - domain.boundaries.begin())];
    drive = {motion.velocity, motion.spin, motion.centre.value_or(drive.centre), !motion.absent};
  }
  return drives;
}

}  // namespace arenite::dem
