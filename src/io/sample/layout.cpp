#include "io/sample/layout.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/option.hpp"
#include "core/text.hpp"
#include "io/sample/formats.hpp"
#include "statistics/correlation.hpp"

namespace arenite::io {
namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};
constexpr std::array<int, 2> planes[] = {{0, 1}, {0, 2}, {1, 2}};  // in the order in which they are preferred
constexpr double flat = 0.02;  // of the mean radius: rounding and the drift of a plane run
constexpr double layer = 1;    // of it: no two grains of one layer lie on top of each other

double mean_radius(const RawGrains& grains) {
  return statistics::mean_of_known(mapped(grains.rows, [](const RawGrain& g) { return std::max(g.radius, 0.0); }));
}

/// How far the centres reach along an axis.
double extent_along(const RawGrains& grains, int axis) {
  const auto along = mapped(grains.rows, [axis](const RawGrain& g) { return g.place[axis]; });
  const auto [low, high] = std::ranges::minmax(along);
  return high - low;
}

int across(std::array<int, 2> plane) { return 3 - plane[0] - plane[1]; }
std::string name_of(std::array<int, 2> plane) {
  return fmt::format("{}-{}", axis_names[plane[0]], axis_names[plane[1]]);
}

/// The plane of the centres, if they lie in one, and whether they do only to a part of a radius.
struct FoundPlane {
  std::array<int, 2> axes;
  double share;  ///< extent across it over the mean radius
};
FoundPlane find_plane(const RawGrains& grains) {
  const double radius = mean_radius(grains);
  const auto depth = [&](std::array<int, 2> plane) { return extent_along(grains, across(plane)); };
  for (const auto plane : planes)
    if (depth(plane) <= flat * radius) return {plane, 0};
  const auto thinnest = *std::ranges::min_element(planes, {}, depth);
  return {thinnest, depth(thinnest) / radius};
}

void note_plane(const FoundPlane& plane, std::vector<std::string>& notes) {
  if (plane.share > 0)
    notes.push_back(
        fmt::format("The centres differ by {:.2g} mean radii along {}; they were measured as they lie in the plane {}, "
                    "as if they did not.",
                    plane.share, axis_names[across(plane.axes)], name_of(plane.axes)));
  else if (across(plane.axes) != 2)
    notes.push_back(fmt::format("The centres lie in the plane {}, which was taken.", name_of(plane.axes)));
}

std::string edge_words(Vec3 v) { return fmt::format("({:g} {:g} {:g})", v.x, v.y, v.z); }
/// How the edges of a cell have to lie.
std::string right_edges(const Frame<2>& frame) {
  return fmt::format("along {} and in the plane {}", axis_names[frame.axis[0]], name_of(frame.axis));
}
std::string right_edges(const Frame<3>& /*frame*/) { return "along x, in the plane x-y and along z"; }

/// The stated cell, if it has an area or a volume there.
template <int D>
void take_cell(const RawCell& stated, Laid<D>& laid, std::vector<std::string>& notes, Problems& problems) {
  const auto& axis = laid.frame.axis;
  double slack = 0;
  std::vector<std::string> edges;
  for (const int a : axis) {
    slack += 1e-9 * norm(stated.edge[a]);
    edges.push_back(edge_words(stated.edge[a]));
  }
  for (int k = 0; k < D; ++k)
    for (int across = 0; across < 3; ++across) {
      const bool may = across == axis[k] || (k == 1 && across == axis[0]);
      if (may || std::abs(stated.edge[axis[k]][across]) <= slack) continue;
      return problems.add("the vectors of the cell, {} m, do not lie {}; write the cell so", list_of(edges, " and "),
                          right_edges(laid.frame));
    }
  const Vec<D> corner = laid.frame.of(stated.corner),
               size = by_axis<D>([&](int k) { return stated.edge[axis[k]][axis[k]]; });
  for (int k = 0; k < D; ++k)
    if (!(size[k] > 0))
      return notes.push_back(fmt::format(
          "The file states a box of {:g} m along {}, which is no size, so its box is left aside; {} gives another.",
          size[k], axis_names[axis[k]], option("box")));
  laid.lay_box(corner, corner + size);
  laid.cell.tilt = stated.edge[axis[1]][axis[0]];
  for (int k = 0; k < D; ++k) laid.cell.periodic[k] = stated.periodic[axis[k]];
}

/// From the lowest to the highest centre along an axis of the sample.
template <int D> std::pair<double, double> span_of(const RawGrains& grains, const Laid<D>& laid, int axis) {
  const auto along = mapped(grains.rows, [&](const RawGrain& g) { return laid.frame.of(g.place)[axis]; });
  const auto [low, high] = std::ranges::minmax(along);
  return {low, high};
}

/// Whether the centres fit between the walls of an axis; if not, a problem.
bool fit_between_walls(double span, double size, int axis, const std::string& mend, Problems& problems) {
  if (span > size)
    problems.add("the centres span {:g} m along {}, more than the box's {:g} m; correct {}", span, axis_names[axis],
                 size, mend);
  return span <= size;
}

template <int D> void check_stated_box(RawGrains& grains, const Laid<D>& laid, Problems& problems) {
  for (int axis = 0; axis < D; ++axis) {
    if (laid.cell.periodic[axis]) continue;
    const auto [low, high] = span_of(grains, laid, axis);
    const int named = laid.frame.axis[axis];
    if (!fit_between_walls(high - low, laid.cell.extent(axis), named,
                           "the box that the file states, or give another by " + option("box"), problems))
      continue;
    const double from = laid.cell.wall[2 * axis].position, to = laid.cell.wall[2 * axis + 1].position;
    if (low < from || high > to)
      grains.notes.push_back(
          fmt::format("Centres lie from {:g} to {:g} m along {}, in part outside the box that the file states, from "
                      "{:g} to {:g} m; it was taken as it is, and {} and {} give another.",
                      low, high, axis_names[named], from, to, option("box"), option("origin")));
  }
}

template <int D> void place_box(RawGrains& grains, Laid<D>& laid, Problems& problems) {
  for (int axis = 0; axis < D; ++axis) {
    const auto [low, high] = span_of(grains, laid, axis);
    const double size = laid.cell.extent(axis);
    if (laid.cell.periodic[axis] || (low >= 0 && high <= size)) continue;
    fit_between_walls(high - low, size, laid.frame.axis[axis], option("box") + " or " + option("length-unit"),
                      problems);
    const double corner = 0.5 * (low + high) - 0.5 * size;
    laid.cell.wall[2 * axis].position = corner;
    laid.cell.wall[2 * axis + 1].position = corner + size;
    grains.notes.push_back(
        fmt::format("The centres do not lie between 0 and the box's {:g} m along {}, so the box was placed around "
                    "them, from {:g} m; {} sets its position.",
                    size, axis_names[laid.frame.axis[axis]], corner, option("origin")));
  }
}

}  // namespace

void lay_out(RawGrains& grains, int dimension, Problems& problems) {
  if (grains.rows.empty()) return problems.add("there are no grains; give one row per grain");
  if (dimension != 3) {
    const FoundPlane plane = find_plane(grains);
    grains.in_space = plane.share > layer;
    if (grains.in_space && dimension == 2)
      problems.add(
          "the centres fill space: they differ by {:.3g} mean radii even along {}, but a sample in a plane is wanted; "
          "give one layer of grains",
          plane.share, axis_names[across(plane.axes)]);
    grains.in_space = grains.in_space && dimension != 2;
    grains.plane.frame.axis = plane.axes;
    if (!grains.in_space && plane.share <= layer) note_plane(plane, grains.notes);
  } else {
    grains.in_space = true;
  }
  if (grains.stated) grains.laid([&](auto& laid) { take_cell(*grains.stated, laid, grains.notes, problems); });
}

void check_stated_box(RawGrains& grains, Problems& problems) {
  if (!grains.rows.empty()) grains.laid([&](const auto& laid) { check_stated_box(grains, laid, problems); });
}

void place_box(RawGrains& grains, Problems& problems) {
  if (!grains.rows.empty()) grains.laid([&](auto& laid) { place_box(grains, laid, problems); });
}

}  // namespace arenite::io
