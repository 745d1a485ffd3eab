#include "io/sample/plane.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "core/mapped.hpp"
#include "geometry/rectangle.hpp"
#include "io/sample/formats.hpp"
#include "statistics/correlation.hpp"

namespace arenite::io {
namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};
constexpr Plane planes[] = {{0, 1}, {0, 2}, {1, 2}};  // in the order in which they are preferred
constexpr double flat = 0.02;                         // of the mean radius: rounding and the drift of a plane run
constexpr double layer = 1;                           // of it: no two grains of one layer lie on top of each other

double mean_radius(const RawGrains& grains) {
  return statistics::mean_of_known(mapped(grains.rows, [](const RawGrain& g) { return std::max(g.radius, 0.0); }));
}

/// How far the centres reach along an axis.
double extent_along(const RawGrains& grains, int axis) {
  const auto along = mapped(grains.rows, [axis](const RawGrain& g) { return g.place[axis]; });
  const auto [low, high] = std::ranges::minmax(along);
  return high - low;
}

std::string name_of(const Plane& plane) {
  return fmt::format("{}-{}", axis_names[plane.first], axis_names[plane.second]);
}

Plane plane_of(const RawGrains& grains, std::vector<std::string>& notes, Problems& problems) {
  const double radius = mean_radius(grains);
  const auto depth = [&](const Plane& plane) { return extent_along(grains, plane.across()); };
  for (const Plane& plane : planes) {
    if (!(depth(plane) <= flat * radius)) continue;
    if (plane.across() != 2)
      notes.push_back(fmt::format("The centres lie in the plane {}, which was taken.", name_of(plane)));
    return plane;
  }
  const Plane thinnest = *std::ranges::min_element(planes, {}, depth);
  const double share = depth(thinnest) / radius;
  if (share <= layer)
    notes.push_back(
        fmt::format("The centres differ by {:.2g} mean radii along {}; they were measured as they lie in the plane {}, "
                    "as if they did not.",
                    share, axis_names[thinnest.across()], name_of(thinnest)));
  else
    problems.add(
        "the centres fill space: they differ by {:.3g} mean radii even along {}, but only samples in a plane are "
        "measured; give one layer of grains",
        share, axis_names[thinnest.across()]);
  return thinnest;
}

/// The stated cell in the plane, if it has an area there.
void take_cell(RawGrains& grains, Problems& problems) {
  const RawCell& stated = *grains.stated;
  const Plane& plane = grains.plane;
  const Vec3 a = stated.edge[plane.first], b = stated.edge[plane.second];
  const double slack = 1e-9 * (norm(a) + norm(b));
  const auto is_zero = [&](double x) { return std::abs(x) <= slack; };
  if (!is_zero(a[plane.second]) || !is_zero(a[plane.across()]) || !is_zero(b[plane.across()])) {
    problems.add(
        "the vectors of the cell, ({:g} {:g} {:g}) and ({:g} {:g} {:g}) m, do not lie along {} and in the plane {}; "
        "write the cell so",
        a.x, a.y, a.z, b.x, b.y, b.z, axis_names[plane.first], name_of(plane));
    return;
  }
  const Vec2 corner = plane.of(stated.corner), size{a[plane.first], b[plane.second]};
  if (!(size.x > 0 && size.y > 0)) return;
  grains.lay_box(corner, corner + size);
  grains.cell.tilt = b[plane.first];
  grains.cell.periodic = {stated.periodic[plane.first], stated.periodic[plane.second]};
}

}  // namespace

void lay_in_plane(RawGrains& grains, Problems& problems) {
  if (grains.rows.empty()) return problems.add("there are no grains; give one row per grain");
  grains.plane = plane_of(grains, grains.notes, problems);
  for (RawGrain& g : grains.rows) g.centre = grains.plane.of(g.place);
  if (grains.stated) take_cell(grains, problems);
}

void place_box(RawGrains& grains, Problems& problems) {
  if (grains.rows.empty()) return;
  const auto centres = mapped(grains.rows, &RawGrain::centre);
  const geometry::Rectangle around = geometry::bounds(centres);
  const auto place = [&](int axis, double low, double high, const char* name) {
    const double size = grains.cell.extent(axis);
    if (grains.cell.periodic[axis] || (low >= 0 && high <= size)) return;
    if (high - low > size)
      problems.add("the centres span {:g} m along {}, more than the box's {:g} m; correct --box or --length-unit",
                   high - low, name, size);
    const double corner = 0.5 * (low + high) - 0.5 * size;
    grains.cell.wall[2 * axis].position = corner;
    grains.cell.wall[2 * axis + 1].position = corner + size;
    grains.notes.push_back(
        fmt::format("The centres do not lie between 0 and the box's {:g} m along {}, so the box was placed around "
                    "them, from {:g} m; --origin sets its position.",
                    size, name, corner));
  };
  place(0, around.x_min, around.x_max, "x");
  place(1, around.y_min, around.y_max, "y");
}

}  // namespace arenite::io
