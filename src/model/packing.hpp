#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.hpp"
#include "model/domain.hpp"
#include "model/links.hpp"

namespace arenite {

/// A constitutive material of grains; parameters that concern a pair follow from two of these (dem/laws).
struct Material {
  std::string name;
  double density = 0;                         ///< kg/m^3
  double stiffness = 0;                       ///< contact stiffness k, N/m (T ch. 2)
  double thermoelastic_factor = 0;            ///< A, K/Pa (T ch. 2); 0 if not known
  std::optional<double> youngs_modulus = {};  ///< E, Pa, and
  std::optional<double> poisson = {};         ///< Poisson's ratio nu, for laws of these
  bool operator==(const Material&) const = default;
};

using Materials = std::vector<Material>;

/// Place of what has that name among materials, boundaries and the like; their number if there is none.
template <class Named> std::size_t index_of(const std::vector<Named>& all, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(all, name, &Named::name) - all.begin());
}

/// What grains are that are no single disks (shapes.hpp): rigid, of several disks each. Grain g has the disks first[g]
/// to first[g + 1] - 1. Empty where all grains are disks; else a grain that is one has itself.
struct Shapes {
  std::vector<std::int32_t> first;   ///< by grain, and one more
  std::vector<Vec2> place;           ///< by disk: from the grain's centre of mass where the grain's angle is 0, m
  std::vector<double> radius;        ///< by disk, m
  std::vector<std::uint8_t> filled;  ///< by grain; 1: the convex polygon of its disks' centres, counter-clockwise,
                                     ///< widened by their common radius
  std::vector<double> gyration;      ///< by grain: radius of gyration about the centre of mass, m
  bool empty() const { return first.empty(); }
  bool operator==(const Shapes&) const = default;
};

/// Grains as a structure of arrays: cylinders of equal length seen end on, so disks unless `shapes` says otherwise; in
/// space spheres. All arrays have one length. Index = position in these arrays = what Contacts refer to; `id` is the
/// user's name for a grain.
template <int D> struct GrainsIn {
  std::vector<std::int64_t> id;
  std::vector<Vec<D>> position;        ///< of the centre of mass, m
  std::vector<double> radius;          ///< m; of a grain that is no disk that of the disk of its area
  std::vector<std::int32_t> material;  ///< index into Materials
  std::vector<Turning<D>>
      angle;                     ///< rotation since the start, rad, counter-clockwise; of spheres the integral of omega
  std::vector<Vec<D>> velocity;  ///< m/s
  std::vector<Turning<D>> omega;   ///< rad/s
  std::vector<std::uint8_t> zone;  ///< 0: none; > 0: number of a region (1: glued agglomerate)
  Shapes shapes;                   ///< in the plane alone

  std::size_t size() const { return position.size(); }
  double area() const requires(D == 2);    ///< of all disks, m^2
  double volume() const requires(D == 3);  ///< of all spheres, m^3
  double mean_diameter() const;            ///< m; 0 without grains
  /// Resizes every array; new grains are at rest at the origin, radius 0, id = index.
  void resize(std::size_t n);
};
using Grains = GrainsIn<2>;

/// Those of the grains, at rest, with centres counted from `origin`.
Grains picked(const Grains& from, const std::vector<std::int32_t>& grains, Vec2 origin = {});

/// What Contacts::j says of a partner that is no grain: below 0 stand the sides, and behind these, four in the plane
/// and six in space, the elements of boundaries.
constexpr std::int32_t wall_partner(int side) { return -1 - side; }
template <int D = 2> constexpr std::int32_t boundary_partner(int element) {
  return wall_partner(sides_in<D> - 1) - 1 - element;
}
constexpr bool is_wall(std::int32_t partner) { return partner < 0; }  ///< of a boundary as well
template <int D = 2> constexpr bool is_boundary(std::int32_t partner) {
  return partner < wall_partner(sides_in<D> - 1);
}
/// From the number of sides on: of a boundary.
constexpr int wall_side(std::int32_t partner) { return -1 - partner; }
template <int D = 2> constexpr int element_of(std::int32_t partner) {
  return wall_partner(sides_in<D> - 1) - 1 - partner;
}

/// Contacts as a structure of arrays, each physical contact once. A contact joins grain i with grain j, or with a wall:
/// then j = wall_partner(side) < 0, which goes on behind the sides with the elements of boundaries,
/// boundary_partner(element). n points from j to i, t is n turned by +90 degrees, and the force on i is fn n + ft t (fn
/// > 0 pushes apart), in space fn n + ft x n; the force on j is the opposite. The contact point lies at x_i - arm_i n
/// and, for two disks, at x_j + arm_j n, so the branch vector from j to i is (arm_i + arm_j) n. The arms of grains that
/// are no disks begin off their centres, and two of them may meet in more than one contact.
template <int D> struct ContactsIn {
  std::vector<std::int32_t> i, j;
  std::vector<Vec<D>> normal;
  std::vector<double> fn;                    ///< N
  std::vector<Turning<D>> ft;                ///< N
  std::vector<double> arm_i, arm_j;          ///< m; arm_j = 0 for a wall
  std::vector<double> overlap;               ///< h, m; NaN where the source of the data does not say
  std::vector<Turning<D>> sliding_velocity;  ///< v_s, m/s, counted as ft; NaN where unknown
  std::vector<std::uint8_t> glued;           ///< 1 where adhesion acts
  std::vector<Vec<D>> off_i,
      off_j;  ///< from the centre to where the arm begins, m; empty where all grains are disks or spheres

  std::size_t size() const { return i.size(); }
  bool is_wall(std::size_t c) const { return arenite::is_wall(j[c]); }
  int wall_side(std::size_t c) const { return arenite::wall_side(j[c]); }  ///< from sides_in<D> on: of a boundary
  bool is_boundary(std::size_t c) const { return arenite::is_boundary<D>(j[c]); }
  int element(std::size_t c) const { return element_of<D>(j[c]); }  ///< of the boundary that the contact joins
  Vec<D> force_on_i(std::size_t c) const { return fn[c] * normal[c] + cross(ft[c], normal[c]); }
  /// From the centre of grain i to the contact point; the same of grain j (0 for a wall), m.
  Vec<D> lever_i(std::size_t c) const {
    const Vec<D> arm = -arm_i[c] * normal[c];
    return off_i.empty() ? arm : off_i[c] + arm;
  }
  Vec<D> lever_j(std::size_t c) const {
    const Vec<D> arm = arm_j[c] * normal[c];
    return off_j.empty() ? arm : off_j[c] + arm;
  }
  /// From the centre of grain i to that of grain j, or to the wall, m.
  Vec<D> branch(std::size_t c) const {
    return off_i.empty() ? -(arm_i[c] + arm_j[c]) * normal[c] : lever_i(c) - lever_j(c);
  }
  /// Adds one contact; overlap and sliding velocity unknown, not glued.
  void add(std::int32_t i, std::int32_t j, Vec<D> normal, double fn, Turning<D> ft, double arm_i, double arm_j);
};
using Contacts = ContactsIn<2>;

/// Grains in their container, with the contacts between them where these are known. This is what one stage hands to the
/// next, and what texture, exports and figures read, whether it was simulated or measured.
template <int D> struct PackingIn {
  Materials materials;
  DomainIn<D> domain;
  GrainsIn<D> grains;
  ContactsIn<D> contacts;
  std::vector<BondIn<D>> bonds;        ///< sorted by (i, j), broken ones as well
  std::vector<CohesivePair> cohesive;  ///< sorted by (i, j)
};
using Packing = PackingIn<2>;

/// Mass of a disk as long as its container is thick, or of a sphere, kg; of a grain by its material's density; of all.
inline double mass_of(double density, double radius, const Domain& domain) {
  return density * std::numbers::pi * radius * radius * domain.thickness;
}
inline double mass_of(double density, double radius, const DomainIn<3>& /*domain*/) {
  return density * (4.0 / 3.0 * std::numbers::pi * radius * radius * radius);
}
template <int D> double mass_of(const PackingIn<D>& packing, std::size_t grain) {
  const GrainsIn<D>& all = packing.grains;
  return mass_of(packing.materials.at(all.material[grain]).density, all.radius[grain], packing.domain);
}
template <int D> double mass_of(const PackingIn<D>& packing);
/// Mass of all over what they fill, kg/m^3.
template <int D> double mean_density(const PackingIn<D>& packing);

/// Mean normal force of the contacts between grains that push; a contact above it is strong. 0 without such contacts.
template <int D> double mean_compressive_force(const ContactsIn<D>& contacts);

/// From j to i of a bond now, or of a pair that a pull joins, m, and its force on i, N.
template <int D, class Link> Vec<D> branch_of(const PackingIn<D>& packing, const Link& link) {
  return packing.domain.nearest_image(packing.grains.position[link.i] - packing.grains.position[link.j]);
}
template <int D> Vec<D> force_on_i(const PackingIn<D>& packing, const BondIn<D>& bond);
template <int D> Vec<D> force_on_i(const PackingIn<D>& packing, const CohesivePair& pair);

/// A pull across a gap, which no contact has in it.
inline bool acts_across_gap(const CohesivePair& pair) { return pair.gap > 0; }

}  // namespace arenite
