#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <type_traits>

#include "geometry/rotation.hpp"
#include "grains/dem/parameters.hpp"

namespace arenite::dem {

/// What the loops read of a disk or sphere; a disk's is one cache line, a sphere's one and a half. Velocities are those
/// that the forces see.
template <int D> struct alignas(D == 2 ? 64 : 32) GrainRecord {
  Vec<D> place{}, velocity{};
  Turning<D> omega{};
  double radius = 0, mass = 0;
  std::int32_t material = 0;
  std::int32_t grain = 0;  ///< the caller's index
};
using DiskRecord = GrainRecord<2>;
static_assert(sizeof(DiskRecord) == 64 && sizeof(GrainRecord<3>) == 96);

/// What a spring remembers goes along with a contact that turns, and with the mean twist of its grains, which turn at
/// `spin` together, in a time: in the plane it is a number, in space it is laid into the contact's plane and turned
/// there, as long as it was.
template <int D, class V>
inline Turning<D, V> turned_along(const Turning<D, V>& remembered, const Vec<D, V>& normal, const Turning<D, V>& spin,
                                  double time) {
  if constexpr (D == 2) return remembered;
  else {
    using lane::select, lane::sqrt;
    const Vec<D, V> in_plane = without_twist(remembered, normal),
                    turned = in_plane + V(0.5 * time) * dot(spin, normal) * cross(normal, in_plane);
    const V square = dot(turned, turned);
    return select(square > V(0.0), sqrt(dot(remembered, remembered) / square), V(0.0)) * turned;
  }
}

/// Of a disk, a sphere: I/(m r^2).
template <int D> inline constexpr double inertia_share = D == 2 ? 0.5 : 0.4;
template <int D> inline double inertia(const GrainRecord<D>& d) {
  return inertia_share<D> * d.mass * d.radius * d.radius;
}

/// Force of a contact on i, N, and its torques on i and j, N m; all 0 where apart. Of spheres without a gap: what many
/// of them take is the time to write and read it.
template <int D> struct alignas(D == 2 ? 32 : 8) SlotForce {
  Vec<D> on_i;
  Turning<D> torque_i{}, torque_j{};
};
template <int D> inline bool acts(const SlotForce<D>& f) { return f.on_i != Vec<D>{}; }

/// Velocity, m/s, and turning, rad/s.
template <int D> struct Motion {
  Vec<D> velocity;
  Turning<D> omega{};
};

/// Forces on something, N, and their torque about its centre, N m.
template <int D> struct Load {
  Vec<D> force;
  Turning<D> torque{};
};

/// Forces of slots and how they are gathered: group and first as in ContactList.
template <int D> struct SlotForces {
  const SlotForce<D>* force;
  const std::int32_t *group, *first;
  bool fetches = false;  ///< forces ahead of their turn
};

/// On disk or sphere k by its contacts, its slots in a fixed order.
template <int D> inline Load<D> contact_load(const SlotForces<D>& slots, std::size_t k) {
  const auto sum = [&](std::size_t q) {
    SlotForce<D> total;
    for (auto g = slots.first[q]; g < slots.first[q + 1]; g += 4) {
      const auto at = [&](int n) -> const SlotForce<D>& { return slots.force[slots.group[g + n]]; };
      const SlotForce<D>&a = at(0), &b = at(1), &c = at(2), &d = at(3);
      total.on_i += (a.on_i + b.on_i) + (c.on_i + d.on_i);
      total.torque_i += (a.torque_i + b.torque_i) + (c.torque_i + d.torque_i);
      total.torque_j += (a.torque_j + b.torque_j) + (c.torque_j + d.torque_j);
    }
    return total;
  };
  const SlotForce<D> own = sum(2 * k), reaction = sum(2 * k + 1);
  return {own.on_i - reaction.on_i, own.torque_i + reaction.torque_j};
}

/// What the pair loop reads and fills; the arrays are those of ContactList.
template <int D> struct PairTask {
  const GrainRecord<D>* record;
  const std::int32_t *i, *j;
  const double *stiffness, *damping, *viscosity, *strength, *shear;
  std::array<double*, turnings<D>> memory;
  double* normal_memory;
  SlotForce<D>* force;
  double friction;   ///< mu
  double floor;      ///< lowest F_n of contacts that are not glued, N
  double arm_share;  ///< of the overlap that each arm lacks: 1/2 (contact point) or 0 (full radius)
  bool fetches;      ///< records ahead of their turn
};

/// What the loop over the pairs' rolling resistance reads and fills; the arrays are those of ContactList, its forces
/// those of the pair loop.
template <int D> struct RollingTask {
  const GrainRecord<D>* record;
  const std::int32_t *i, *j;
  const double *stiffness, *damping;
  std::array<double*, turnings<D>> memory;
  double* twist_memory;  ///< null where twisting is not resisted
  SlotForce<D>* force;
  double lead, lag;  ///< s, of the memory (Slip)
};

/// What is known of a bond of disks that holds; of eight of them side by side, it is what the loop over the bonds
/// reads.
template <class Number> struct FlatRow : BeamArms<Number> {
  Vec<2, Number> normal{};      ///< from j to i when the list was built
  Number angle_i{}, angle_j{};  ///< that the grains have where it is not bent and has this normal, rad
  BeamOf<Number> beam{};
  Number strength{};  ///< over that of the law; once it has ended none that it could hold with
  BeamDashpots<Number> dashpots{};
  Vec<2, Number> image{}, image_velocity{};  ///< of j beside j itself, m and m/s; only side by side
};
/// The same of a bond of spheres.
template <class Number> struct RoundRow : RoundArms<Number> {
  Vec<3, Number> along_i{}, along_j{};  ///< the line from j to i as it was made, by the axes that turn with each
  Number rest_cosine{};                 ///< how i was turned against j then, by these axes
  Vec<3, Number> rest_sine{};
  RoundBeamOf<Number> beam{};
  Number strength{};
  RoundDashpotsOf<Number> dashpots{};
  Vec<3, Number> image{}, image_velocity{};
};
template <int D, class Number> using BondRow = std::conditional_t<D == 2, FlatRow<Number>, RoundRow<Number>>;
using Eight = std::array<double, 8>;

/// What the loop over the bonds reads and fills; the arrays are those of BondNumbers.
template <int D> struct BondTask {
  const GrainRecord<D>* record;
  const std::conditional_t<D == 2, double, geometry::Rotation>* attitude;  ///< angles by disk; rotations by `grain`
  const std::int32_t *i, *j;
  const BondRow<D, Eight>* row;
  SlotForce<D>* force;
  std::uint8_t*
      look;  ///< where a bond may break, or has turned far since the list was built: then it is not for the loop to say
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
template <int D> struct SweepTask {
  GrainRecord<D>* record;
  SlotForces<D> slots;
  std::array<double*, D> velocity, acceleration;
  std::array<double*, turnings<D>> omega, angle, alpha;
  std::array<std::array<double*, 3>, D + turnings<D>> higher;
  std::array<double*, D> listed;
  Vec<D> gravity;                              ///< m/s^2
  CellMotion<D> before, after;                 ///< of the cell, at the start and the end of the step
  std::array<Stretch, D> moved, listed_moved;  ///< of the cell, in the step and since the list was built
  double dt, kick, ahead;                      ///< s, see integrators/integrator.hpp
  double drag;                                 ///< 1/s
  double turning;                              ///< 1 where grains rotate, else 0
  double listed_shear, middle;  ///< shear of the cell since the list was built, about the height `middle`, m
  double limit;                 ///< square of the way that a disk may be from its place in the list, m^2
};

/// From where a disk was when the list was built, as the cell has taken it along since, to its place.
template <int D, class V> inline Vec<D, V> way_since_listed(const SweepTask<D>& t, Vec<D, V> place, Vec<D, V> listed) {
  const auto then = by_axis<D>([&](int axis) { return t.listed_moved[axis].apply(listed[axis]); });
  Vec<D, V> way = place - then;
  way.x = way.x - V(t.listed_shear) * (then.y - V(t.middle));
  return way;
}

inline constexpr std::size_t adhesions = std::variant_size_v<Adhesion::variant>,
                             friction_laws = std::variant_size_v<FrictionLaw::variant>,
                             law_triples = std::variant_size_v<NormalLaw::variant> * adhesions * friction_laws,
                             bond_laws = std::variant_size_v<BondLaw::variant>,
                             rolling_laws = std::variant_size_v<RollingLaw::variant>;
inline std::size_t loop_index(const ContactLaws& laws) {
  return (laws.normal.index() * adhesions + laws.adhesion.index()) * friction_laws + laws.friction.index();
}

/// The inner loops, compiled once for each kind of processor. All kernels give the same bits: the same exactly rounded
/// operations in the same order for every contact and disk, only more of them at a time.
template <int D> struct KernelIn {
  const char* name;
  /// Forces of slots begin .. end-1, all of two disks; one loop for every three laws (loop_index).
  using PairLoop = void (*)(const PairTask<D>&, const ContactLaws&, std::size_t begin, std::size_t end);
  std::array<PairLoop, law_triples> pair_loops;
  /// A step of disks begin .. end-1; one loop for every integrator (IntegratorKind). False if the list has become
  /// stale.
  using Sweep = bool (*)(const SweepTask<D>&, std::size_t begin, std::size_t end);
  std::array<Sweep, integrator_count> sweeps;
  /// Forces of bonds begin .. end-1; one loop for every bond law. True if some need a closer look.
  using BondLoop = bool (*)(const BondTask<D>&, const BondLaw&, std::size_t begin, std::size_t end);
  std::array<BondLoop, bond_laws> bond_loops;
  /// Moments of slots begin .. end-1, all of two disks, by the forces that the pair loop has left; one loop for every
  /// law of rolling.
  using RollingLoop = void (*)(const RollingTask<D>&, const RollingLaw&, std::size_t begin, std::size_t end);
  std::array<RollingLoop, rolling_laws> rolling_loops;
};
using Kernel = KernelIn<2>;

extern const Kernel portable_kernel, avx2_kernel, avx512_kernel;
extern const KernelIn<3> portable_sphere_kernel, avx2_sphere_kernel, avx512_sphere_kernel;

/// The kernel that `asked` means on this machine: "auto" is the widest it has. InputError for one that is unknown or
/// that the processor lacks.
template <int D> const KernelIn<D>& find_kernel(const std::string& asked);

}  // namespace arenite::dem
