#pragma once
#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "grains/dem/coefficients.hpp"
#include "grains/dem/energy_balance.hpp"
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
  bool open = false;               ///< taken away
};
using WallBody = WallBodyIn<2>;

/// A boundary that has a mass moves under forces.
struct BoundaryBody {
  double mass = 0;  ///< kg; 0: it moves as it is told
  Vec2 force;       ///< of the drive, N
  Vec2 rate;        ///< integrated velocity, m/s (half a step behind under Verlet)
};

/// What a disk can touch of a boundary: one of its points, or the segment from there to the next. The number of an
/// element is its place among those of all boundaries (Domain::elements).
struct Element {
  std::int32_t boundary = 0, point = 0;
  bool segment = false;
};

/// A grain that goes with a rough wall: its centre in the wall's own coordinates, which start at `slid` along the wall
/// and at its plane.
struct HeldGrain {
  std::int32_t grain = 0, side = 0;  ///< the caller's index
  Vec2 place;                        ///< m
};

/// A rigid grain of several disks, which go where it goes.
struct Body {
  std::int32_t first = 0, count = 0;  ///< its disks, by their place in Sample::start
  std::int64_t filled = 0;            ///< see Shapes; a whole number of words, for a state is told by its bytes
  double gyration = 0, mass = 0;      ///< m, kg
  Vec2 place;                         ///< of the centre of mass
  double angle = 0;
  Motion<2> own, seen;  ///< integrated velocities, less the affine motion of a periodic cell; those that the forces see
  double inertia() const { return mass * gyration * gyration; }
};

/// A disk of a body, or one for itself.
struct BodyDisk {
  std::int32_t grain = 0, body = -1;  ///< the caller's index; -1 for a grain that is a disk
  Vec2 place;                         ///< from the centre of mass where the body's angle is 0, m
  Cells<2> shift;                     ///< between the disk and its body's centre
};

/// Where a disk may touch a polygon: the point of the polygon's core nearest to the disk's centre, seen as a disk of
/// the polygon's rounding that goes with it. Its record stands behind those of the ghosts, and its slot joins the disk
/// with it. Each corner meets the other polygon by itself, so the energy is a sum over corners of squared distances
/// from convex cores, and the force runs on without a jump from a side over a corner. A boundary's point that juts out
/// has a foot, too, like a corner without radius.
struct Foot {
  std::int32_t touches = 0, body = 0;  ///< inner number of the disk, or boundary_partner of the point; the polygon
  Cells<2> shift;                      ///< from the body's centre to the image that is meant
  Vec2 lever;                          ///< from the body's centre, m
};

/// What is of the plane: what a sample can have beside single disks and walls, and the account of its energy.
template <int D> struct PlaneParts {};
template <> struct PlaneParts<2> {
  Programmes programmes;         ///< of the stage under way; not saved, since every stage sets them
  std::vector<Element> element;  ///< of the domain's boundaries
  std::vector<BoundaryBody> boundary;
  std::vector<Foot> foot,
      point_foot;  ///< of disks and of boundaries' points; the records of the latter are the last ones
  Grains
      given;  ///< the caller's, where some are no disks: `start` then has their disks, and "grain" within means a disk
  std::vector<Body> body;
  std::vector<BodyDisk> part;           ///< by disk of `start`; empty where all grains are disks
  std::vector<std::int32_t> part_disk;  ///< the disks' inner numbers; renewed with the list
  std::vector<Vec2> lever;  ///< by inner number: from the centre of a disk's body to its own; empty like `part`

  std::vector<HeldGrain> held;          ///< sorted by grain
  std::vector<std::int32_t> held_disk;  ///< their inner numbers; renewed with the list
  std::vector<double> held_angle;       ///< and their angles, which do not change
  std::vector<Bond> bonds;              ///< sorted by their grains; without the forces of now
  std::vector<BondSlot> bond_slots;     ///< of the bonds that held when the list was built
  BondNumbers bond_numbers;
  EnergyBalance balance;  ///< only if track_energy
};

/// Everything that decides the future, and the set-up that follows from it. Disks (in space spheres) are kept in an
/// inner order that follows the cells; `record[k].grain` leads back to the caller's.
template <int D> struct SampleIn : PlaneParts<D> {
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
      higher;                     ///< Gear: of each coordinate and angle the third to fifth derivatives
  std::vector<Ghost<D>> ghost;    ///< and behind them one for each foot of a disk
  ContactListIn<D> list, former;  ///< `former`: the list before the last rebuild, kept for its memory
  double skin = 0, largest_radius = 0;
  Components<D> listed;  ///< where the disks were when the list was built
  DomainIn<D> listed_domain;
  double sheared = 0, listed_sheared = 0;  ///< shear strain by shear_rate so far, and when the list was built
  std::int64_t builds = 0;
  std::vector<std::uint64_t> live_bonds;  ///< sorted keys of glued pairs, where these part for good
  CohesionTable cohesion;

  Energies tally;        ///< dissipation and work so far
  bool settled = false;  ///< the integrator has its starting values
};

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

/// Of a grain (caller's index) that goes with a rough wall; nullptr of any other.
inline const HeldGrain* find_held(const Sample& s, std::int32_t grain) {
  const auto at = std::lower_bound(s.held.begin(), s.held.end(), grain,
                                   [](const HeldGrain& h, std::int32_t g) { return h.grain < g; });
  return at != s.held.end() && at->grain == grain ? &*at : nullptr;
}
constexpr const HeldGrain* find_held(const SampleIn<3>& /*s*/, std::int32_t /*grain*/) { return nullptr; }

/// The body that a disk of `start` belongs to; -1 for none. The caller's index of its grain.
template <int D> inline std::int32_t body_of(const SampleIn<D>& s, std::int32_t disk) {
  if constexpr (D == 2) return s.part.empty() ? -1 : s.part[disk].body;
  else return -1;
}
template <int D> inline std::int32_t grain_of(const SampleIn<D>& s, std::int32_t disk) {
  if constexpr (D == 2) return s.part.empty() ? disk : s.part[disk].grain;
  else return disk;
}
template <int D> inline bool is_part(const SampleIn<D>& s, std::size_t k) { return body_of(s, s.record[k].grain) >= 0; }
/// How many bodies there are.
template <int D> inline std::size_t body_count(const SampleIn<D>& s) {
  if constexpr (D == 2) return s.body.size();
  else return 0;
}
/// Where a disk that is a grain, or the body of one that is not, stands in arrays over the disks of `start` and the
/// bodies behind them.
inline std::size_t mover_of(const Sample& s, std::int32_t disk) {
  const std::int32_t body = body_of(s, disk);
  return body < 0 ? static_cast<std::size_t>(disk) : s.count + static_cast<std::size_t>(body);
}
inline std::size_t grain_count(const Sample& s) { return s.part.empty() ? s.count : s.given.size(); }

/// Centres of touching disks, or of disks in the list, are never farther apart, m.
template <int D> inline double reach_of(const SampleIn<D>& s) {
  return 2.0 * s.largest_radius + s.skin + s.cohesion.reach;
}

}  // namespace arenite::dem
