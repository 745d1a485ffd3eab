#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.hpp"
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

/// What grains are that are no single disks (shapes.hpp): rigid, of several disks each. Grain g has the disks first[g] to first[g + 1] - 1. Empty where
/// all grains are disks; else a grain that is one has itself.
struct Shapes {
  std::vector<std::int32_t> first;   ///< by grain, and one more
  std::vector<Vec2> place;           ///< by disk: from the grain's centre of mass where the grain's angle is 0, m
  std::vector<double> radius;        ///< by disk, m
  std::vector<std::uint8_t> filled;  ///< by grain; 1: the convex polygon of its disks' centres, counter-clockwise, widened by their common radius
  std::vector<double> gyration;      ///< by grain: radius of gyration about the centre of mass, m
  bool empty() const { return first.empty(); }
  bool operator==(const Shapes&) const = default;
};

/// Grains as a structure of arrays: cylinders of equal length seen end on, so disks unless `shapes` says otherwise; in space spheres. All arrays have one length.
/// Index = position in these arrays = what Contacts refer to; `id` is the user's name for a grain.
template <int D> struct GrainsIn {
  std::vector<std::int64_t> id;
  std::vector<Vec<D>> position;        ///< of the centre of mass, m
  std::vector<double> radius;          ///< m; of a grain that is no disk that of the disk of its area
  std::vector<std::int32_t> material;  ///< index into Materials
  std::vector<Turning<D>> angle;       ///< rotation since the start, rad, counter-clockwise; of spheres the integral of omega
  std::vector<Vec<D>> velocity;        ///< m/s
  std::vector<Turning<D>> omega;       ///< rad/s
  std::vector<std::uint8_t> zone;      ///< 0: none; > 0: number of a region (1: glued agglomerate)
  Shapes shapes;                       ///< in the plane alone

  std::size_t size() const { return position.size(); }
  double area() const requires(D == 2);  ///< of all disks, m^2
  double mean_diameter() const;          ///< m; 0 without grains
  /// Resizes every array; new grains are at rest at the origin, radius 0, id = index.
  void resize(std::size_t n);
};
using Grains = GrainsIn<2>;

/// Those of the grains, at rest, with centres counted from `origin`.
Grains picked(const Grains& from, const std::vector<std::int32_t>& grains, Vec2 origin = {});

/// The rigid planes of a container, two an axis, in this order everywhere (arrays, files, figures).
enum Side : int { left = 0, right = 1, bottom = 2, top = 3 };
template <int D> inline constexpr int sides_in = 2 * D;
inline constexpr int sides = sides_in<2>;
template <class T> using BySide = std::array<T, sides>;
inline constexpr BySide<const char*> side_names{"left", "right", "bottom", "top"};

/// The axis that is normal to a side, and +1 if the way into the sample from there is along it, else -1.
constexpr int axis_of(int side) { return side / 2; }
constexpr double inward_sign(int side) { return side % 2 == 0 ? 1.0 : -1.0; }
/// Unit normal of a wall, into the sample.
template <int D = 2> constexpr Vec<D> inward_normal(int side) {
  Vec<D> normal;
  normal[axis_of(side)] = inward_sign(side);
  return normal;
}

/// What lies along a side: in the plane a number, y of left and right and x of bottom and top, in space a vector without the component along the normal.
template <int D> using Along = std::conditional_t<D == 2, double, Vec<D>>;

/// Of a vector along the normal of a side, and along the side itself.
template <int D> constexpr double across(int side, Vec<D> v) { return v[axis_of(side)]; }
constexpr double along(int side, Vec2 v) { return v[1 - axis_of(side)]; }
/// The vector of which these are the two.
constexpr Vec2 of_side(int side, double across, double along) { return axis_of(side) == 0 ? Vec2{across, along} : Vec2{along, across}; }
constexpr Vec3 of_side(int side, double across, Vec3 along) {
  along[axis_of(side)] = across;
  return along;
}
constexpr Vec3 along(int side, Vec3 v) { return of_side(side, 0, v); }

/// One rigid plane. `position` is its coordinate along the axis that is normal to it.
template <int D> struct WallIn {
  bool present = true;
  double position = 0;        ///< m
  double velocity = 0;        ///< m/s, along the axis
  double force = 0;           ///< normal force that the grains exert on it, N, compression positive
  Along<D> shear_force = {};  ///< tangential force that the grains exert on it, N
};
using Wall = WallIn<2>;

/// A rigid boundary of straight segments within the container: a hopper, a gate, a drum, an intruder. It is thin, with grains on either side, and moves as
/// it is told, whatever the grains do. Like a wall it may be absent.
struct Boundary {
  std::string name;
  std::vector<Vec2> points;  ///< m; a segment joins each with the next
  bool closed = false;       ///< and the last with the first
  bool present = true;
  Vec2 velocity;      ///< m/s
  double spin = 0;    ///< rad/s, counter-clockwise about the centre
  Vec2 centre;        ///< m; goes with the velocity
  Vec2 force;         ///< that the grains exert on it, N
  double torque = 0;  ///< of the grains about the centre, N m
  bool operator==(const Boundary&) const = default;
};

/// The mean of points, m.
Vec2 mean_point(const std::vector<Vec2>& points);

/// So many periodic cells along each axis.
template <int D> using Cells = Vec<D, std::int32_t>;

/// What holds a sample along its axes: a wall at either end, or periodic sides (then the walls of that direction are absent, and their positions are the
/// edges of the cell).
template <int D> struct Container {
  std::array<WallIn<D>, sides_in<D>> wall;
  std::array<bool, D> periodic{};  ///< by axis
  double tilt = 0;                 ///< x-shift of the upper image of a sheared periodic cell (Lees-Edwards), m

  double extent(int axis) const { return wall[2 * axis + 1].position - wall[2 * axis].position; }
  Vec<D> size() const {
    return by_axis<D>([&](int axis) { return extent(axis); });
  }
  /// The lowest one, or (1) the one across from it.
  Vec<D> corner(int end = 0) const {
    return by_axis<D>([&](int axis) { return wall[2 * axis + end].position; });
  }
  bool is_periodic(int side) const { return periodic[axis_of(side)]; }
  bool is_cell() const { return std::ranges::any_of(periodic, std::identity()); }  ///< along one axis at least
  /// How far a place lies within the plane of a side, m.
  double depth(int side, Vec<D> place) const { return side % 2 == 0 ? across(side, place) - wall[side].position : wall[side].position - across(side, place); }

  /// From a place to its image so many cells on, m.
  Vec<D> way(Cells<D> cells) const {
    Vec<D> way = by_axis<D>([&](int axis) { return cells[axis] * extent(axis); });
    way.x += cells.y * tilt;
    return way;
  }
  /// In which cell a place lies, counted from the one of now; 0 along axes that are not periodic. The place moved from there into the one of now.
  Cells<D> cell_of(Vec<D> place) const { return whole(floors(place)); }
  Vec<D> wrapped(Vec<D> place) const { return moved_back(place, floors(place)); }
  /// By how many cells a vector between two points is longer than the one to the nearest periodic image, and that one.
  Cells<D> cells_between(Vec<D> d) const { return whole(nearest(d)); }
  Vec<D> nearest_image(Vec<D> d) const { return moved_back(d, nearest(d)); }
  /// Whether a place is in the periodic cell or nearer to it than a reach.
  bool is_near(Vec<D> place, double reach) const {
    bool near = true;
    for (int axis = 0; axis < D; ++axis)
      if (periodic[axis]) near = near && place[axis] > wall[2 * axis].position - reach && place[axis] < wall[2 * axis + 1].position + reach;
    return near;
  }
  /// Calls `see` for the cell of now, 0, and those around it, along x first.
  template <class See> void each_near_cell(const See& see) const { near_cells<D - 1>({}, see); }

 private:
  template <class Round> Vec<D> counted(Vec<D> v, Vec<D> from, const Round& round) const {
    Vec<D> cells;
    for (int axis = D - 1; axis >= 0; --axis) {
      if (axis == 0) v.x -= cells.y * tilt;
      if (periodic[axis]) cells[axis] = round((v[axis] - from[axis]) / extent(axis));
    }
    return cells;
  }
  Vec<D> floors(Vec<D> place) const {
    return counted(place, corner(), [](double n) { return std::floor(n); });
  }
  Vec<D> nearest(Vec<D> d) const {
    return counted(d, {}, [](double n) { return std::nearbyint(n); });
  }
  static Cells<D> whole(Vec<D> cells) {
    return by_axis<D>([&](int axis) { return static_cast<std::int32_t>(cells[axis]); });
  }
  Vec<D> moved_back(Vec<D> v, Vec<D> cells) const {
    v.x -= cells.y * tilt;
    return by_axis<D>([&](int axis) { return v[axis] - cells[axis] * extent(axis); });
  }
  template <int axis, class See> void near_cells(Cells<D> cells, const See& see) const {
    const std::int32_t most = periodic[axis] ? 1 : 0;
    for (cells[axis] = -most; cells[axis] <= most; ++cells[axis])
      if constexpr (axis == 0) see(cells);
      else near_cells<axis - 1>(cells, see);
  }
};

/// What holds the sample: a container, and boundaries within.
struct Domain : Container<2> {
  double thickness = 1;              ///< out-of-plane length L of the cylinders, m
  std::vector<Boundary> boundaries;  ///< beside the walls

  double width() const { return extent(0); }
  double height() const { return extent(1); }
  double area() const { return width() * height(); }
  double length(int side) const { return extent(1 - axis_of(side)); }  ///< along it
  /// How many elements the boundaries have: two a point, the point itself and the segment from it to the next, counted through all boundaries. The
  /// last segment of an open boundary counts, though nothing touches it.
  int elements() const;
  /// The boundary that an element belongs to; -1 for a number beyond them.
  int boundary_of(int element) const;
};

/// Boundaries are of the plane.
template <int D> using DomainIn = std::conditional_t<D == 2, Domain, Container<D>>;

/// What Contacts::j says of a partner that is no grain: below 0 stand the four sides, and behind them the elements of boundaries.
constexpr std::int32_t wall_partner(int side) { return -1 - side; }
constexpr std::int32_t boundary_partner(int element) { return wall_partner(top) - 1 - element; }
constexpr bool is_wall(std::int32_t partner) { return partner < 0; }  ///< of a boundary as well
constexpr bool is_boundary(std::int32_t partner) { return partner < wall_partner(top); }
constexpr int wall_side(std::int32_t partner) { return -1 - partner; }  ///< 4 and more: of a boundary
constexpr int element_of(std::int32_t partner) { return wall_partner(top) - 1 - partner; }

/// Contacts as a structure of arrays, each physical contact once. A contact joins grain i with grain j, or with a wall: then j = wall_partner(side) <
/// 0, which goes on behind the four sides with the elements of boundaries, boundary_partner(element). n points from j to i, t is n turned by +90 degrees,
/// and the force on i is fn n + ft t (fn > 0 pushes apart), in space fn n + ft x n; the force on j is the opposite.
/// The contact point lies at x_i - arm_i n and, for two disks, at x_j + arm_j n, so the branch vector from j to i is (arm_i + arm_j) n. The arms of
/// grains that are no disks begin off their centres, and two of them may meet in more than one contact.
template <int D> struct ContactsIn {
  std::vector<std::int32_t> i, j;
  std::vector<Vec<D>> normal;
  std::vector<double> fn;                    ///< N
  std::vector<Turning<D>> ft;                ///< N
  std::vector<double> arm_i, arm_j;          ///< m; arm_j = 0 for a wall
  std::vector<double> overlap;               ///< h, m; NaN where the source of the data does not say
  std::vector<Turning<D>> sliding_velocity;  ///< v_s, m/s, counted as ft; NaN where unknown
  std::vector<std::uint8_t> glued;           ///< 1 where adhesion acts
  std::vector<Vec<D>> off_i, off_j;          ///< from the centre to where the arm begins, m; empty where all grains are disks or spheres

  std::size_t size() const { return i.size(); }
  bool is_wall(std::size_t c) const { return arenite::is_wall(j[c]); }
  int wall_side(std::size_t c) const { return arenite::wall_side(j[c]); }  ///< 4 and more: of a boundary
  bool is_boundary(std::size_t c) const { return arenite::is_boundary(j[c]); }
  int element(std::size_t c) const { return element_of(j[c]); }  ///< of the boundary that the contact joins
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
  Vec<D> branch(std::size_t c) const { return off_i.empty() ? -(arm_i[c] + arm_j[c]) * normal[c] : lever_i(c) - lever_j(c); }
  /// Adds one contact; overlap and sliding velocity unknown, not glued.
  void add(std::int32_t i, std::int32_t j, Vec<D> normal, double fn, Turning<D> ft, double arm_i, double arm_j);
};
using Contacts = ContactsIn<2>;

/// Grains in their container, with the contacts between them where these are known. This is what one stage hands to the next, and what texture, exports
/// and figures read, whether it was simulated or measured.
template <int D> struct PackingIn {
  Materials materials;
  DomainIn<D> domain;
  GrainsIn<D> grains;
  ContactsIn<D> contacts;
  std::vector<Bond> bonds;             ///< sorted by (i, j), broken ones as well
  std::vector<CohesivePair> cohesive;  ///< sorted by (i, j)
};
using Packing = PackingIn<2>;

/// Mean normal force of the contacts between grains that push; a contact above it is strong. 0 without such contacts.
double mean_compressive_force(const Contacts& contacts);

/// From j to i of a bond now, or of a pair that a pull joins, m, and its force on i, N.
template <class Link> Vec2 branch_of(const Packing& packing, const Link& link) {
  return packing.domain.nearest_image(packing.grains.position[link.i] - packing.grains.position[link.j]);
}
Vec2 force_on_i(const Packing& packing, const Bond& bond);
Vec2 force_on_i(const Packing& packing, const CohesivePair& pair);

/// A pull across a gap, which no contact has in it.
inline bool acts_across_gap(const CohesivePair& pair) { return pair.gap > 0; }

}  // namespace arenite
