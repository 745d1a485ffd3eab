#include "recipe/keys/face_shapes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <vector>

#include "core/decimals.hpp"
#include "geometry/face.hpp"
#include "geometry/polygon.hpp"
#include "model/shapes.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

namespace {

// What stands for the faces of a boundary; a recipe holds the corners that follow. In plan x is the first coordinate
// and z the second.

void add_face(const std::vector<Vec3>& corners, BoundaryIn<3>& boundary) {
  boundary.points.insert(boundary.points.end(), corners.begin(), corners.end());
  boundary.corners.push_back(static_cast<std::int32_t>(corners.size()));
}

/// Corners of a circle's regular polygon.
geometry::Polygon ring(Vec2 centre, double diameter, std::int64_t segments) {
  return points_on_arc(centre, diameter, {0, 2 * std::numbers::pi}, segments, segments);
}

/// A level circle about an upright axis; a point where its diameter is 0.
struct Rim {
  double height, diameter;
};

/// The faces between two rims: trapezoids, or triangles where one is a point.
void add_band(Vec2 axis, Rim low, Rim high, std::int64_t segments, BoundaryIn<3>& boundary) {
  const geometry::Polygon lower = ring(axis, low.diameter, segments), upper = ring(axis, high.diameter, segments);
  for (std::size_t k = 0; k < lower.size(); ++k) {
    const std::size_t next = (k + 1) % lower.size();
    std::vector<Vec3> corners{{lower[k].x, low.height, lower[k].y}};
    if (low.diameter > 0) corners.push_back({lower[next].x, low.height, lower[next].y});
    if (high.diameter > 0) corners.push_back({upper[next].x, high.height, upper[next].y});
    corners.push_back({upper[k].x, high.height, upper[k].y});
    add_face(corners, boundary);
  }
}

/// The part of a convex polygon to the left of the line from a to b.
geometry::Polygon left_of(const geometry::Polygon& polygon, Vec2 a, Vec2 b) {
  geometry::Polygon part;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Vec2 here = polygon[k], next = polygon[(k + 1) % polygon.size()];
    const double now = cross(b - a, here - a), then = cross(b - a, next - a);
    if (now >= 0) part.push_back(here);
    if (now * then < 0) part.push_back(here + now / (now - then) * (next - here));
  }
  return part;
}

struct Plate {
  double y = 0;
  ByAnySide<std::optional<double>> edge;
  std::optional<double> x, z, diameter, width, depth;
  std::int64_t segments = 32;

  void declare(Visitor& v) {
    v.number({"y", "Height above the container's bottom.", true}, y, "mm", range::any);
    for (const std::size_t side : {left, right, back, front})
      v.number(
          {any_side_names[side], side < back ? "Edge, from the container's left side; unless given, the container's."
                                             : "Edge, from the container's back; unless given, the container's."},
          edge[side], "mm", range::any);
    v.number({"diameter", "Of a round opening."}, diameter, "mm", range::positive);
    v.integer({"segments", "Number of straight edges of a round opening."}, segments, {3, 512});
    v.number({"opening_width", "Of a rectangular opening, along x; it then needs its depth."}, width, "mm",
             range::positive);
    v.number({"opening_depth", "Of a rectangular opening, along z."}, depth, "mm", range::positive);
    v.number({"x", "Middle of the opening, from the container's left side; unless given, that of the plate."}, x, "mm",
             range::any);
    v.number({"z", "Middle of the opening, from the container's back; unless given, that of the plate."}, z, "mm",
             range::any);
    v.require(width.has_value() == depth.has_value() && !(diameter && width),
              {"opening_width", "opening_depth", "diameter"}, "an opening has a diameter, or a width and a depth");
  }

  geometry::Polygon opening(Vec2 middle) const {
    if (diameter) return ring(middle, *diameter, segments);
    if (!width) return {};
    const double x0 = middle.x - 0.5 * *width, x1 = middle.x + 0.5 * *width, z0 = middle.y - 0.5 * *depth,
                 z1 = middle.y + 0.5 * *depth;
    return {{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}};
  }

  /// From the middle of the opening each of its edges sees a part of the plate.
  void add_to(BoundaryIn<3>& boundary, const ContainerParameters& container) const {
    const double x0 = edge[left].value_or(0), x1 = edge[right].value_or(container.width), z0 = edge[back].value_or(0),
                 z1 = edge[front].value_or(container.depth);
    const geometry::Polygon whole{{x0, z0}, {x1, z0}, {x1, z1}, {x0, z1}};
    const Vec2 middle{x.value_or(0.5 * (x0 + x1)), z.value_or(0.5 * (z0 + z1))};
    const geometry::Polygon gap = opening(middle);
    if (gap.empty()) return add_part(whole, boundary);
    for (std::size_t k = 0; k < gap.size(); ++k) {
      const Vec2 a = gap[k], b = gap[(k + 1) % gap.size()];
      add_part(left_of(left_of(left_of(whole, b, a), middle, a), b, middle), boundary);
    }
  }

 private:
  /// Where the opening reaches an edge of the plate nothing is left.
  void add_part(const geometry::Polygon& part, BoundaryIn<3>& boundary) const {
    std::vector<Vec3> corners;
    for (const Vec2 place : part) {
      const double size = std::max({std::abs(place.x), std::abs(place.y), std::abs(y)});
      corners.push_back({in_decimals(place.x, size), y, in_decimals(place.y, size)});
    }
    const auto are_one = [&](Vec3 a, Vec3 b) { return norm(a - b) <= 1e-9 * (norm(a) + norm(b)); };
    corners.erase(std::unique(corners.begin(), corners.end(), are_one), corners.end());
    while (corners.size() > 1 && are_one(corners.front(), corners.back())) corners.pop_back();
    if (geometry::is_flat_and_convex(corners)) add_face(corners, boundary);
  }
};

struct Cone {
  Vec2 centre;
  double low = 0, high = 0, low_diameter = 0, high_diameter = 0;
  std::int64_t segments = 32;

  void declare(Visitor& v) {
    v.number({"x", "Of the axis, from the container's left side.", true}, centre.x, "mm", range::any);
    v.number({"z", "Of the axis, from the container's back.", true}, centre.y, "mm", range::any);
    v.number({"bottom", "Height of its lower rim above the container's bottom.", true}, low, "mm", range::any);
    v.number({"top", "Height of its upper rim above the container's bottom.", true}, high, "mm", range::any);
    v.number({"bottom_diameter", "Of the circle on which the corners of its lower rim lie.", true}, low_diameter, "mm",
             range::positive);
    v.number({"top_diameter", "Of the circle of its upper rim.", true}, high_diameter, "mm", range::positive);
    v.integer({"segments", "Number of flat faces."}, segments, {3, 512});
    v.require(low < high, {"top", "bottom"}, "must be above bottom");
  }

  void add_to(BoundaryIn<3>& boundary) const {
    add_band(centre, {low, low_diameter}, {high, high_diameter}, segments, boundary);
  }
};

struct Ball {
  Vec3 centre;
  double diameter = 0;
  std::int64_t segments = 32;

  void declare(Visitor& v) {
    v.number({"x", "Of the centre, from the container's left side.", true}, centre.x, "mm", range::any);
    v.number({"y", "Of the centre, above the container's bottom.", true}, centre.y, "mm", range::any);
    v.number({"z", "Of the centre, from the container's back.", true}, centre.z, "mm", range::any);
    v.number({"diameter", "Of the sphere on which the corners lie.", true}, diameter, "mm", range::positive);
    v.integer({"segments", "Number of faces around it; half as many lie from pole to pole, which are below and above."},
              segments, {4, 128});
    v.require(segments % 2 == 0, {"segments"}, "must be even, for half as many lie from pole to pole");
  }

  /// Trapezoids between circles of latitude, and triangles at the poles.
  void add_to(BoundaryIn<3>& boundary) const {
    constexpr double pi = std::numbers::pi;
    const std::vector<Vec2> meridian =  // distance from the axis, height
        points_on_arc({0, centre.y}, diameter, {-0.5 * pi, 2 * pi}, segments, segments / 2 + 1);
    const auto rim = [&](std::size_t k) {
      const bool is_pole = k == 0 || k + 1 == meridian.size();
      return Rim{meridian[k].y, is_pole ? 0 : 2 * meridian[k].x};
    };
    for (std::size_t k = 0; k + 1 < meridian.size(); ++k)
      add_band({centre.x, centre.z}, rim(k), rim(k + 1), segments, boundary);
  }
};

/// How many corners each face has; one that has all of them is not written.
void declare_corners(Visitor& v, BoundaryIn<3>& boundary) {
  v.points({"corners", "Corners of flat convex faces, in order around each, from the lower left corner at the back."},
           boundary.points, "mm");
  std::vector<double> counts(boundary.corners.begin(), boundary.corners.end());
  if (counts.size() == 1) counts.clear();
  v.numbers({"faces", "Number of corners of each face, where there are several: the first have so many corners first."},
            counts, "", range::between(3, 1e6));
  if (counts.empty() && !boundary.points.empty()) counts = {static_cast<double>(boundary.points.size())};
  double all = 0;
  for (const double count : counts) all += count;
  v.require(std::ranges::all_of(counts, [](double count) { return count == std::floor(count); }) &&
                all == static_cast<double>(boundary.points.size()),
            {"faces", "corners"}, "must be whole numbers that add up to that of the corners");
  boundary.corners.assign(counts.begin(), counts.end());
}

/// The first of its faces, counted from 1, that is none; 0 where all are.
std::size_t first_bent(const BoundaryIn<3>& boundary) {
  const std::vector<geometry::Face> faces = geometry::faces_of(boundary.points, boundary.corners);
  const auto bent = std::ranges::find_if_not(faces, geometry::is_flat_and_convex) - faces.begin();
  return static_cast<std::size_t>(bent) < boundary.corners.size() ? static_cast<std::size_t>(bent) + 1 : 0;
}

}  // namespace

void declare_faces(Visitor& v, BoundaryIn<3>& boundary, const ContainerParameters& container) {
  declare_corners(v, boundary);
  int given = boundary.points.empty() ? 0 : 1;
  std::optional<Plate> plate;
  v.optional_section<Plate>({"plate", "A level plate, with an opening perhaps, instead of corners."}, plate,
                            [](Visitor& inner, Plate& it) { it.declare(inner); });
  std::optional<Cone> cone;
  v.optional_section<Cone>({"cone", "A cone without its tip, or a tube, of flat faces instead of corners."}, cone,
                           [](Visitor& inner, Cone& it) { it.declare(inner); });
  std::optional<Ball> ball;
  v.optional_section<Ball>({"ball", "A ball of flat faces instead of corners: an intruder."}, ball,
                           [](Visitor& inner, Ball& it) { it.declare(inner); });
  given += (plate ? 1 : 0) + (cone ? 1 : 0) + (ball ? 1 : 0);
  v.require(given == 1, {"corners", "plate", "cone", "ball"},
            given == 0 ? "is missing; give corners, or a plate, a cone or a ball"
                       : "give one of corners, plate, cone and ball");
  if (plate) plate->add_to(boundary, container);
  if (cone) cone->add_to(boundary);
  if (ball) ball->add_to(boundary);
  v.require(!plate || !boundary.points.empty(), {"plate"}, "has an opening that leaves nothing of it");
  const std::size_t bent = first_bent(boundary);
  v.require(bent == 0, {"corners"},
            fmt::format("face {} is not flat and convex, or has two corners at one place; give its corners in order "
                        "around it, or part it",
                        bent));
}

}  // namespace arenite::recipe
