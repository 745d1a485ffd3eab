#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>

#include "grains/dem/laws/laws.hpp"

namespace arenite::dem {

/// What the loops read of a disk or sphere; a disk's is one cache line. Velocities are those that the forces see.
template <int D> struct alignas(64) GrainRecord {
  Vec<D> place{}, velocity{};
  Turning<D> omega{};
  double radius = 0, mass = 0;
  std::int32_t material = 0;
  std::int32_t grain = 0;  ///< the caller's index
};
using DiskRecord = GrainRecord<2>;
static_assert(sizeof(DiskRecord) == 64);
inline double inertia(const DiskRecord& d) { return 0.5 * d.mass * d.radius * d.radius; }

/// Force of a contact on i, N, and its torques on i and j, N m; all 0 where apart.
struct alignas(32) SlotForce {
  Vec2 on_i;
  double torque_i = 0, torque_j = 0;
};
inline bool acts(const SlotForce& f) { return f.on_i != Vec2{}; }

/// What the pair loop reads and fills; the arrays are those of ContactList.
struct PairTask {
  const DiskRecord* record;
  const std::int32_t *i, *j;
  const double *stiffness, *damping, *viscosity, *strength, *shear;
  double *memory, *normal_memory;
  SlotForce* force;
  double friction;   ///< mu
  double floor;      ///< lowest F_n of contacts that are not glued, N
  double arm_share;  ///< of the overlap that each arm lacks: 1/2 (contact point) or 0 (full radius)
};

/// What is known of a bond that holds, or where the arrays of these numbers are, which the loop over the bonds reads.
template <class Number> struct BondRow : BeamArms<Number> {
  Vec<2, Number> normal{};      ///< from j to i when the list was built
  Number angle_i{}, angle_j{};  ///< that the grains have where it is not bent and has this normal, rad
  BeamOf<Number> beam{};
  Number strength{};  ///< over that of the law; once it has ended none that it could hold with
  BeamDashpots<Number> dashpots{};
  Vec<2, Number> image{}, image_velocity{};  ///< of j beside j itself, m and m/s; only of the arrays
};
inline constexpr std::size_t bond_columns = sizeof(BondRow<double>) / sizeof(double);

/// What the loop over the bonds reads and fills; the arrays are those of BondNumbers.
struct BondTask {
  const DiskRecord* record;
  const double* angle;
  const std::int32_t *i, *j;
  BondRow<const double*> column;
  SlotForce* force;
  std::uint8_t* look;  ///< where a bond may break, or has turned far since the list was built: then it is not for the loop to say
  bool damped;
};

/// Velocity of an affine motion along one direction: `at_edge` + `gradient` (x - edge).
struct AffineMotion {
  double edge = 0, at_edge = 0, gradient = 0;
  template <class V> V at(V x) const { return V(at_edge) + V(gradient) * (x - V(edge)); }
};

/// The same along each axis.
template <int D> struct CellMotion {
  std::array<AffineMotion, D> along;
  template <class V> Vec<D, V> at(Vec<D, V> place) const {
    return by_axis<D>([&](int axis) { return along[axis].at(place[axis]); });
  }
};

/// Where a growing or moving cell takes a point; as it stands, the identity.
struct Stretch {
  double from = 0, scale = 1, to = 0;
  template <class V> V apply(V x) const { return V(to) + (x - V(from)) * V(scale); }
  double growth() const { return scale - 1; }
};

/// What a step of an integrator reads and changes; the arrays are those of Sample and ContactList.
struct SweepTask {
  DiskRecord* record;
  const SlotForce* force;
  const std::int32_t *group, *first;
  std::array<double*, 2> velocity, acceleration;
  double *omega, *angle, *alpha;
  std::array<std::array<double*, 3>, 3> higher;
  std::array<const double*, 2> listed;
  Vec2 gravity;                                ///< m/s^2
  CellMotion<2> before, after;                 ///< of the cell, at the start and the end of the step
  std::array<Stretch, 2> moved, listed_moved;  ///< of the cell, in the step and since the list was built
  double dt, kick, ahead;                      ///< s, see integrators/verlet.cpp
  double drag;                                 ///< 1/s
  double turning;                              ///< 1 where grains rotate, else 0
  double listed_shear, middle;                 ///< shear of the cell since the list was built, about the height `middle`, m
  double limit;                                ///< square of the way that a disk may be from its place in the list, m^2
};

/// From where a disk was when the list was built, as the cell has taken it along since, to its place.
template <class V> Vec<2, V> way_since_listed(const SweepTask& t, Vec<2, V> place, Vec<2, V> listed) {
  const auto then = by_axis<2>([&](int axis) { return t.listed_moved[axis].apply(listed[axis]); });
  Vec<2, V> way = place - then;
  way.x = way.x - V(t.listed_shear) * (then.y - V(t.middle));
  return way;
}

inline constexpr std::size_t adhesions = std::variant_size_v<Adhesion::variant>, friction_laws = std::variant_size_v<FrictionLaw::variant>,
                             law_triples = std::variant_size_v<NormalLaw::variant> * adhesions * friction_laws,
                             bond_laws = std::variant_size_v<BondLaw::variant>;
inline std::size_t loop_index(const ContactLaws& laws) {
  return (laws.normal.index() * adhesions + laws.adhesion.index()) * friction_laws + laws.friction.index();
}

/// The inner loops, compiled once for each kind of processor. All kernels give the same bits: the same exactly rounded operations in the same order
/// for every contact and disk, only more of them at a time.
struct Kernel {
  const char* name;
  /// Forces of slots begin .. end-1, all of two disks; one loop for every three laws (loop_index).
  using PairLoop = void (*)(const PairTask&, const ContactLaws&, std::size_t begin, std::size_t end);
  std::array<PairLoop, law_triples> pair_loops;
  /// A step of disks begin .. end-1. False if the list has become stale.
  using Sweep = bool (*)(const SweepTask&, std::size_t begin, std::size_t end);
  Sweep verlet, gear;
  /// Forces of bonds begin .. end-1; one loop for every bond law. True if some need a closer look.
  using BondLoop = bool (*)(const BondTask&, const BondLaw&, std::size_t begin, std::size_t end);
  std::array<BondLoop, bond_laws> bond_loops;
};

extern const Kernel portable_kernel, avx2_kernel, avx512_kernel;

/// The kernel that `asked` means on this machine: "auto" is the widest it has. InputError for one that is unknown or that the processor lacks.
const Kernel& find_kernel(const std::string& asked);

}  // namespace arenite::dem
