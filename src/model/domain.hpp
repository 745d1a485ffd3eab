#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <string>
#include <type_traits>
#include <vector>

#include "core/vec.hpp"

namespace arenite {

/// The rigid planes of a container, two an axis, in this order everywhere (arrays, files, figures). In space y points
/// up as in the plane, and z from back to front.
enum Side : int { left = 0, right = 1, bottom = 2, top = 3, back = 4, front = 5 };
template <int D> inline constexpr int sides_in = 2 * D;
inline constexpr int sides = sides_in<2>;
template <class T> using BySide = std::array<T, sides>;
/// Of what is asked for in a dimension that is not known before: in the plane the last two stay empty.
template <class T> using ByAnySide = std::array<T, sides_in<3>>;
inline constexpr ByAnySide<const char*> any_side_names{"left", "right", "bottom", "top", "back", "front"};
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

/// What lies along a side: in the plane a number, y of left and right and x of bottom and top, in space a vector
/// without the component along the normal.
template <int D> using Along = std::conditional_t<D == 2, double, Vec<D>>;

/// Of a vector along the normal of a side, and along the side itself.
template <int D> constexpr double across(int side, Vec<D> v) { return v[axis_of(side)]; }
constexpr double along(int side, Vec2 v) { return v[1 - axis_of(side)]; }
/// The vector of which these are the two.
constexpr Vec2 of_side(int side, double across, double along) {
  return axis_of(side) == 0 ? Vec2{across, along} : Vec2{along, across};
}
constexpr Vec3 of_side(int side, double across, Vec3 along) {
  along[axis_of(side)] = across;
  return along;
}
constexpr Vec3 along(int side, Vec3 v) { return of_side(side, 0, v); }
/// A way along a side, of left and right along y, of the others along x.
template <int D> constexpr Along<D> way_along(int side, double size);
template <> constexpr double way_along<2>(int /*side*/, double size) { return size; }
template <> constexpr Vec3 way_along<3>(int side, double size) {
  return axis_of(side) == 0 ? Vec3{0, size, 0} : Vec3{size, 0, 0};
}

/// One rigid plane. `position` is its coordinate along the axis that is normal to it.
template <int D> struct WallIn {
  bool present = true;
  double position = 0;        ///< m
  double velocity = 0;        ///< m/s, along the axis
  double force = 0;           ///< normal force that the grains exert on it, N, compression positive
  Along<D> shear_force = {};  ///< tangential force that the grains exert on it, N
};
using Wall = WallIn<2>;

/// How the points of a boundary are joined: in the plane a segment joins each with the next, in space a boundary has
/// flat convex faces, the first of so many points as `corners` says first, then the next.
template <int D> struct BoundaryShape;
template <> struct BoundaryShape<2> {
  bool closed = false;  ///< the last point is joined with the first
  bool operator==(const BoundaryShape&) const = default;
};
template <> struct BoundaryShape<3> {
  std::vector<std::int32_t> corners;
  bool operator==(const BoundaryShape&) const = default;
};

/// A rigid boundary within the container: a hopper, a gate, a drum, an intruder. It is thin, with grains on either
/// side, and moves as it is told, whatever the grains do. Like a wall it may be absent.
template <int D> struct BoundaryIn : BoundaryShape<D> {
  std::string name;
  std::vector<Vec<D>> points;  ///< m
  bool present = true;
  Vec<D> velocity;      ///< m/s
  Turning<D> spin{};    ///< rad/s, counter-clockwise about the centre
  Vec<D> centre;        ///< m; goes with the velocity
  Vec<D> force;         ///< that the grains exert on it, N
  Turning<D> torque{};  ///< of the grains about the centre, N m
  bool operator==(const BoundaryIn&) const = default;
};
using Boundary = BoundaryIn<2>;

/// How many elements a boundary has: two a point of the plane, the point itself and the segment from it to the next; in
/// space its faces. The last segment of an open boundary counts, though nothing touches it.
inline int element_count(const Boundary& boundary) { return static_cast<int>(2 * boundary.points.size()); }
inline int element_count(const BoundaryIn<3>& boundary) { return static_cast<int>(boundary.corners.size()); }

/// The mean of points, m.
template <int D> Vec<D> mean_point(const std::vector<Vec<D>>& points) {
  Vec<D> sum;
  for (const Vec<D>& p : points) sum += p;
  return points.empty() ? sum : sum / static_cast<double>(points.size());
}

/// So many periodic cells along each axis.
template <int D> using Cells = Vec<D, std::int32_t>;

/// What holds a sample along its axes: a wall at either end, or periodic sides (then the walls of that direction are
/// absent, and their positions are the edges of the cell).
template <int D> struct Container {
  std::array<WallIn<D>, sides_in<D>> wall;
  std::array<bool, D> periodic{};  ///< by axis
  double tilt = 0;                 ///< x-shift of the upper image of a sheared periodic cell (Lees-Edwards), m

  double extent(int axis) const { return wall[2 * axis + 1].position - wall[2 * axis].position; }
  Vec<D> size() const {
    return by_axis<D>([&](int axis) { return extent(axis); });
  }
  /// Width, height and in space depth.
  std::array<double, 3> extents() const {
    std::array<double, 3> all{};
    for (int axis = 0; axis < D; ++axis) all[static_cast<std::size_t>(axis)] = extent(axis);
    return all;
  }
  /// The lowest one, or (1) the one across from it.
  Vec<D> corner(int end = 0) const {
    return by_axis<D>([&](int axis) { return wall[2 * axis + end].position; });
  }
  bool is_periodic(int side) const { return periodic[axis_of(side)]; }
  bool is_cell() const { return std::ranges::any_of(periodic, std::identity()); }  ///< along one axis at least
  /// How far a place lies within the plane of a side, m.
  double depth(int side, Vec<D> place) const {
    return side % 2 == 0 ? across(side, place) - wall[side].position : wall[side].position - across(side, place);
  }

  /// From a place to its image so many cells on, m.
  Vec<D> way(Cells<D> cells) const {
    Vec<D> way = by_axis<D>([&](int axis) { return cells[axis] * extent(axis); });
    way.x += cells.y * tilt;
    return way;
  }
  /// In which cell a place lies, counted from the one of now; 0 along axes that are not periodic. The place moved from
  /// there into the one of now.
  Cells<D> cell_of(Vec<D> place) const { return whole(floors(place)); }
  Vec<D> wrapped(Vec<D> place) const { return moved_back(place, floors(place)); }
  /// By how many cells a vector between two points is longer than the one to the nearest periodic image, and that one.
  Cells<D> cells_between(Vec<D> d) const { return whole(nearest(d)); }
  Vec<D> nearest_image(Vec<D> d) const { return moved_back(d, nearest(d)); }
  /// Whether a place is in the periodic cell or nearer to it than a reach.
  bool is_near(Vec<D> place, double reach) const {
    bool near = true;
    for (int axis = 0; axis < D; ++axis)
      if (periodic[axis])
        near =
            near && place[axis] > wall[2 * axis].position - reach && place[axis] < wall[2 * axis + 1].position + reach;
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

/// A container, and boundaries within.
template <int D> struct Vessel : Container<D> {
  std::vector<BoundaryIn<D>> boundaries;  ///< beside the walls

  /// How many elements the boundaries have, counted through all of them.
  int elements() const {
    int all = 0;
    for (const BoundaryIn<D>& boundary : boundaries) all += element_count(boundary);
    return all;
  }
  /// The boundary that an element belongs to; -1 for a number beyond them.
  int boundary_of(int element) const {
    for (std::size_t b = 0; b < boundaries.size(); ++b) {
      const int own = element_count(boundaries[b]);
      if (element < own) return static_cast<int>(b);
      element -= own;
    }
    return -1;
  }
};

/// What holds disks.
struct Domain : Vessel<2> {
  double thickness = 1;  ///< out-of-plane length L of the cylinders, m

  double width() const { return extent(0); }
  double height() const { return extent(1); }
  double area() const { return width() * height(); }
  double length(int side) const { return extent(1 - axis_of(side)); }  ///< along it
};

/// Force of a pressure on a side, N.
inline double thrust_on(const Domain& domain, int side, double pressure) {
  return pressure * domain.length(side) * domain.thickness;
}
inline double thrust_on(const Container<3>& domain, int side, double pressure) {
  const int axis = axis_of(side);
  return pressure * domain.extent((axis + 1) % 3) * domain.extent((axis + 2) % 3);
}
/// m^3.
inline double volume_of(const Domain& domain) { return domain.area() * domain.thickness; }
inline double volume_of(const Container<3>& domain) { return domain.extent(0) * domain.extent(1) * domain.extent(2); }

template <int D> using DomainIn = std::conditional_t<D == 2, Domain, Vessel<D>>;

}  // namespace arenite
