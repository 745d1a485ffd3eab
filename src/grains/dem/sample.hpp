#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <tuple>
#include <vector>

#include "grains/dem/coefficients.hpp"
#include "grains/dem/exchange/exchange.hpp"
#include "grains/dem/parts/parts.hpp"
#include "grains/dem/stage.hpp"
#include "model/packing.hpp"
#include "model/result.hpp"

namespace arenite::dem {

/// The periodic image of a disk or sphere, kept as a record behind the disks'.
template <int D> struct Ghost {
  std::int32_t source = 0;
  Cells<D> shift;
};

/// One wall, or one edge of a periodic cell, as a body that moves along its axis.
template <int D> struct WallBodyIn {
  WallDriveIn<D> drive;
  double sample_mass = 0;          ///< kg
  double mass = 0, impedance = 0;  ///< of a force-controlled wall, kg and N s/m (see walls.cpp)
  double drift = 0;                ///< slow mean of the velocity of a force-controlled wall, m/s along its axis
  double rate = 0;                 ///< integrated velocity (half a step behind under Verlet), m/s along its axis
  double acceleration = 0;
  std::array<double, 4> higher{};  ///< Gear's further derivatives
  Along<D> slid = {};              ///< way along itself so far, m
  bool rough = false;              ///< grains near it when it becomes rough go with it
  bool open = false;               ///< taken away,
  bool skin = false;               ///< for a membrane
};
using WallBody = WallBodyIn<2>;

/// Everything that decides the future, and the set-up that follows from it. Disks (in space spheres) are kept in an
/// inner order that follows the cells; `record[k].grain` leads back to the caller's.
template <int D> struct SampleIn {
  PackingIn<D> start;  ///< as given: materials, ids, zones; its contacts are dropped after the start
  ContactParameters contact;
  IntegrationParameters integration;
  CoefficientTable coefficients;
  ContactLaws laws;
  const KernelIn<D>* kernel = nullptr;  ///< the inner loops in use
  double dt = 0, dt_at_start = 0;       ///< the step, which other masses may shorten where the program chose it
  double friction = 0, wall_friction = 0, drag = 0;
  MassScaling mass_scaling = MassScaling::none;
  double inertial_number = default_inertial_number;  ///< of the servo, see walls.hpp
  Vec<D> gravity;
  double shear_rate = 0;  ///< of a cell that is periodic both ways, du_x/dy, 1/s (Lees and Edwards 1972)
  bool glue = true;

  DomainIn<D> domain;
  std::array<WallBodyIn<D>, sides_in<D>> wall;
  std::int64_t step = 0;
  std::int64_t steps_before = 0;  ///< made before the step was last shortened,
  double time_before = 0;         ///< and the time then, s
  double lag = 0;                 ///< how far the integrated velocities are behind the positions, s: 0 or dt/2

  std::size_t count = 0;  ///< disks; the records behind them are ghosts
  std::vector<GrainRecord<D>> record;
  Components<D> velocity,
      acceleration;  ///< integrated velocities, less the affine motion of a periodic cell; last accelerations
  Turnings<D> omega, angle, alpha;  ///< the same of the turning
  std::array<Components<3>, D + turnings<D>>
      higher;                   ///< Gear: of each coordinate and angle the third to fifth derivatives
  std::vector<Ghost<D>> ghost;  ///< of the disks, and behind these `images` of what parts have there
  std::size_t images = 0;
  ContactListIn<D> list, former;  ///< `former`: the list before the last rebuild, kept for its memory
  double skin = 0, largest_radius = 0;
  Components<D> listed;  ///< where the disks were when the list was built
  DomainIn<D> listed_domain;
  double sheared = 0, listed_sheared = 0;  ///< shear strain by shear_rate so far, and when the list was built
  std::int64_t builds = 0, listed_step = 0;
  std::vector<std::uint64_t> glued_pairs;  ///< sorted keys of the glued pairs that hold, where these part for good
  typename PartsOf<D>::type parts;         ///< what there is beside single disks and walls

  Energies tally;  ///< dissipation and work so far
  ExchangeAccount exchanged;
  bool settled = false;  ///< the integrator has its starting values
};

/// A part of a sample, by its type.
template <class P, class S> auto& the(S& sample) { return std::get<P>(sample.parts); }

/// Calls `see(part)` for each part of a sample, in the order of PartsOf.
template <class S, class See> void each_part(S& sample, const See& see) {
  std::apply([&](auto&... part) { (see(part), ...); }, sample.parts);
}
/// The sum of what `see(part)` returns; whether it is true of one part.
template <int D, class See> auto sum_of_parts(const SampleIn<D>& sample, const See& see) {
  return std::apply([&](const auto&... part) { return (see(part) + ...); }, sample.parts);
}
template <int D, class See> bool any_part(const SampleIn<D>& sample, const See& see) {
  return std::apply([&](const auto&... part) { return (see(part) || ...); }, sample.parts);
}

/// Calls `see` with what moves the disks, array by array.
template <int D, class See> void each_motion_array(SampleIn<D>& s, const See& see) {
  for (auto* vectors : {&s.velocity, &s.acceleration}) std::ranges::for_each(vectors->along, see);
  for (auto* turnings : {&s.omega, &s.angle, &s.alpha}) std::ranges::for_each(turnings->along, see);
}

/// Key of an unordered pair of grains (caller's indices).
inline std::uint64_t pair_key(std::int32_t a, std::int32_t b) {
  const auto low = static_cast<std::uint32_t>(a < b ? a : b), high = static_cast<std::uint32_t>(a < b ? b : a);
  return (std::uint64_t{low} << 32) | high;
}

template <int D> inline std::uint64_t slot_key(const SampleIn<D>& s, std::size_t slot) {
  const std::int32_t a = s.record[s.list.i[slot]].grain;
  const std::int32_t j = s.list.j[slot];
  return pair_key(a, j < 0 ? j : s.record[s.list.owner[slot]].grain);
}

/// Affine motion of a periodic cell: homogeneous between two edges.
template <int D> inline AffineMotion affine_between(const WallIn<D>& a, const WallIn<D>& b) {
  return {a.position, a.velocity, (b.velocity - a.velocity) / (b.position - a.position)};
}
template <int D> inline CellMotion<D> cell_motion(const Container<D>& d) {
  CellMotion<D> motion;
  for (std::size_t axis = 0; axis < motion.along.size(); ++axis)
    if (d.periodic[axis]) motion.along[axis] = affine_between(d.wall[2 * axis], d.wall[2 * axis + 1]);
  return motion;
}

/// Where the periodic cell is, one direction each; nothing moves with it along a side that is not periodic.
struct CellAxis {
  bool periodic = false;
  double edge = 0, length = 1;
  /// Takes a place along from an earlier frame.
  Stretch since(const CellAxis& old) const {
    return periodic ? Stretch{old.edge, length / old.length, edge} : Stretch{};
  }
};
template <int D> using CellFrame = std::array<CellAxis, D>;
template <int D> inline CellFrame<D> cell_frame(const Container<D>& d) {
  CellFrame<D> frame;
  for (std::size_t axis = 0; axis < frame.size(); ++axis)
    frame[axis] = {d.periodic[axis], d.wall[2 * axis].position, d.extent(static_cast<int>(axis))};
  return frame;
}

/// How fast the image of a place some cells on moves past it, m/s.
template <int D> inline Vec<D> image_velocity(const SampleIn<D>& s, Cells<D> shift) {
  if (shift == Cells<D>{}) return {};
  const auto stretch = [&](int axis) {
    return s.domain.periodic[axis] ? s.domain.wall[2 * axis + 1].velocity - s.domain.wall[2 * axis].velocity : 0;
  };
  Vec<D> velocity = by_axis<D>([&](int axis) { return shift[axis] * stretch(axis); });
  velocity.x += shift.y * (s.domain.tilt * stretch(0) / s.domain.extent(0) + s.shear_rate * s.domain.extent(1));
  return velocity;
}

/// Whether a grain (by its index in `start`) goes with a wall, and on which side (-1: none).
template <int D> inline int holding_side(const SampleIn<D>& s, std::int32_t grain) {
  int side = -1;
  each_part(s, [&](const auto& part) { side = std::max(side, part.holding_side(grain)); });
  return side;
}
template <int D> inline bool is_held(const SampleIn<D>& s, std::size_t k) {
  return k < s.count && holding_side(s, s.record[k].grain) >= 0;
}

/// The body that a disk of `start` belongs to; -1 for none. The caller's index of its grain.
template <int D> inline std::int32_t body_of(const SampleIn<D>& s, std::int32_t disk) {
  std::int32_t body = -1;
  each_part(s, [&](const auto& part) { body = std::max(body, part.body_of(disk)); });
  return body;
}
template <int D> inline std::int32_t grain_of(const SampleIn<D>& s, std::int32_t disk) {
  each_part(s, [&](const auto& part) { disk = part.grain_of(disk); });
  return disk;
}
template <int D> inline bool is_part(const SampleIn<D>& s, std::size_t k) { return body_of(s, s.record[k].grain) >= 0; }
/// How many bodies there are.
template <int D> inline std::size_t body_count(const SampleIn<D>& s) {
  return sum_of_parts(s, [](const auto& part) { return part.bodies(); });
}
/// Where a disk that is a grain, or the body of one that is not, stands in arrays over the disks of `start` and the
/// bodies behind them.
template <int D> inline std::size_t mover_of(const SampleIn<D>& s, std::int32_t disk) {
  const std::int32_t body = body_of(s, disk);
  return body < 0 ? static_cast<std::size_t>(disk) : s.count + static_cast<std::size_t>(body);
}
/// The mover that inner disk k is, or is a part of.
template <int D> std::size_t moving(const SampleIn<D>& s, std::int32_t k) {
  const std::int32_t body = body_of(s, s.record[k].grain);
  return body < 0 ? static_cast<std::size_t>(k) : s.count + static_cast<std::size_t>(body);
}

/// The caller's grains: those of `start`, unless some are no disks.
template <int D> inline const GrainsIn<D>& grains_of(const SampleIn<D>& s) {
  const GrainsIn<D>* grains = &s.start.grains;
  each_part(s, [&](const auto& part) {
    if (part.given()) grains = part.given();
  });
  return *grains;
}
template <int D> inline std::size_t grain_count(const SampleIn<D>& s) { return grains_of(s).size(); }
/// The same as `start` has them: all are disks or spheres.
template <int D> inline bool has_disks_only(const SampleIn<D>& s) { return &grains_of(s) == &s.start.grains; }

/// Mass of a disk of `start` that is a grain, or of the body that it belongs to, kg.
template <int D> double own_mass(const SampleIn<D>& s, std::int32_t disk) {
  const bool single = body_of(s, disk) < 0;
  const GrainsIn<D>& g = single ? s.start.grains : grains_of(s);
  const std::int32_t grain = single ? disk : grain_of(s, disk);
  return mass_of(s.start.materials[g.material[grain]].density, g.radius[grain], s.domain);
}

/// The same of a grain of the caller's.
template <int D> double own_mass_of(const SampleIn<D>& s, std::int32_t grain) {
  const GrainsIn<D>& g = grains_of(s);
  return mass_of(s.start.materials[g.material[grain]].density, g.radius[grain], s.domain);
}

/// From the centres of i's and j's bodies to where a slot's force acts on them, m; 0 of a wall and of a disk that is a
/// grain.
template <int D> inline Levers<D> levers_of(const SampleIn<D>& s, std::size_t slot) {
  Levers<D> levers;
  each_part(s, [&](const auto& part) { part.put_levers(s, slot, levers); });
  return levers;
}
/// From the centre of the grain of j, or the wall, to that of i, where `branch` joins the disks, m.
template <int D> inline Vec<D> between_centres(const SampleIn<D>& s, std::size_t slot, Vec<D> branch) {
  const Levers<D> levers = levers_of(s, slot);
  return branch - levers.i + levers.j;
}

/// Since the start, s.
template <int D> double time_of(const SampleIn<D>& s) {
  return s.time_before + static_cast<double>(s.step - s.steps_before) * s.dt;
}

/// How far disks act on each other beyond touch, m.
template <int D> inline double reach_of_parts(const SampleIn<D>& s) {
  return sum_of_parts(s, [](const auto& part) { return part.reach(); });
}
/// Centres of touching disks, or of disks in the list, are never farther apart, m.
template <int D> inline double reach_of(const SampleIn<D>& s) {
  return 2.0 * s.largest_radius + s.skin + reach_of_parts(s);
}

}  // namespace arenite::dem
