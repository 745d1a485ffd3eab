#include "recipe/keys/boundary_shapes.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "core/text.hpp"
#include "model/shapes.hpp"
#include "recipe/keys.hpp"
#include "recipe/keys/face_shapes.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

namespace {

template <int D> void declare_name(Visitor& v, std::string& name, const std::vector<BoundaryIn<D>>& boundaries) {
  v.text({"name", "Name in stages and results: letters, digits, _ and -.", true}, name);
  const bool is_side = std::ranges::count(any_side_names.begin(), any_side_names.begin() + sides_in<D>, name) > 0;
  v.require(is_plain_name(name) && !is_side, {"name"},
            "must be made of letters, digits, _ and -, and not be that of a wall");
  v.require(std::ranges::count(boundaries, name, &BoundaryIn<D>::name) <= 1, {"name"},
            fmt::format("another boundary is called \"{}\"; names must differ", name));
}

// What stands for the points of a boundary; a recipe holds the points that follow.

struct Round {
  Vec2 centre;
  double diameter = 0;
  std::int64_t segments = 64;

  void declare(Visitor& v) {
    v.number({"x", "Of the centre, from the container's left side.", true}, centre.x, "mm", range::any);
    v.number({"y", "Of the centre, from the container's bottom.", true}, centre.y, "mm", range::any);
    v.number({"diameter", "Of the circle on which the points lie.", true}, diameter, "mm", range::positive);
  }
  /// From `from` on, so many segments in a turn by `angle`.
  void add_points(double from, double angle, std::int64_t count, std::vector<Vec2>& points) const {
    const std::vector<Vec2> rim = points_on_arc(centre, diameter, {from, angle}, segments, count);
    points.insert(points.end(), rim.begin(), rim.end());
  }
};

struct Circle : Round {
  void declare(Visitor& v) {
    Round::declare(v);
    v.integer({"segments", "Number of straight segments."}, segments, {3, 4096});
  }
  void add_to(Boundary& boundary) const {
    boundary.closed = true;
    add_points(0, 2 * std::numbers::pi, segments, boundary.points);
  }
};

struct Arc : Round {
  double from = 0, to = std::numbers::pi;

  void declare(Visitor& v) {
    Round::declare(v);
    v.number({"from", "Angle of the first point, counter-clockwise from x."}, from, "deg", range::any);
    v.number({"to", "Angle of the last point."}, to, "deg", range::any);
    v.require(to != from && std::abs(to - from) < 2 * std::numbers::pi, {"to", "from"},
              "must differ from `from` by less than a turn; a whole circle is `circle`");
    v.integer({"segments", "Number of straight segments."}, segments, {1, 4096});
  }
  void add_to(Boundary& boundary) const { add_points(from, to - from, segments + 1, boundary.points); }
};

struct RegularPolygon : Round {
  double angle = 0;
  RegularPolygon() { segments = 6; }

  void declare(Visitor& v) {
    Round::declare(v);
    v.integer({"corners", "Number of corners."}, segments, {3, 64});
    v.number({"angle", "Of the first corner, counter-clockwise from x."}, angle, "deg", range::any);
  }
  void add_to(Boundary& boundary) const {
    boundary.closed = true;
    add_points(angle, 2 * std::numbers::pi, segments, boundary.points);
  }
};

struct Rectangle {
  double left = 0, right = 0, bottom = 0, top = 0;

  void declare(Visitor& v) {
    v.number({"left", "Edge, from the container's left side.", true}, left, "mm", range::any);
    v.number({"right", "Edge, from the container's left side.", true}, right, "mm", range::any);
    v.number({"bottom", "Edge, from the container's bottom.", true}, bottom, "mm", range::any);
    v.number({"top", "Edge, from the container's bottom.", true}, top, "mm", range::any);
    v.require(left < right, {"right", "left"}, "must be right of left");
    v.require(bottom < top, {"top", "bottom"}, "must be above bottom");
  }
  void add_to(Boundary& boundary) const {
    boundary.closed = true;
    boundary.points.insert(boundary.points.end(), {{left, bottom}, {right, bottom}, {right, top}, {left, top}});
  }
};

/// Reads one of them; returns whether it stands there.
template <class Figure> bool declare_figure(Visitor& v, const Key& key, Boundary& boundary) {
  std::optional<Figure> figure;
  v.optional_section<Figure>(key, figure, [](Visitor& inner, Figure& it) { it.declare(inner); });
  if (figure) figure->add_to(boundary);
  return figure.has_value();
}

void declare(Visitor& v, Boundary& boundary, const Recipe& recipe) {
  declare_name(v, boundary.name, recipe.boundaries);
  v.points({"points", "Points joined by straight segments, from the lower left corner of the container."},
           boundary.points, "mm");
  v.flag({"closed", "A segment joins the last point with the first."}, boundary.closed);
  const int given = (boundary.points.empty() ? 0 : 1) +
                    declare_figure<Circle>(v, {"circle", "A circle instead of points."}, boundary) +
                    declare_figure<Arc>(v, {"arc", "An arc of a circle instead of points."}, boundary) +
                    declare_figure<Rectangle>(v, {"rectangle", "A rectangle instead of points."}, boundary) +
                    declare_figure<RegularPolygon>(v, {"polygon", "A regular polygon instead of points."}, boundary);
  v.require(given == 1, {"points", "circle", "arc", "rectangle", "polygon"},
            given == 0 ? "is missing; give points, or a circle, an arc, a rectangle or a polygon"
                       : "give one of points, circle, arc, rectangle and polygon");
  const auto& points = boundary.points;
  v.require(given != 1 || points.size() >= (boundary.closed ? 3u : 2u), {"points"},
            boundary.closed ? "must be three or more where closed" : "must be two or more");
  const bool repeats = std::ranges::adjacent_find(points) != points.end() ||
                       (boundary.closed && !points.empty() && points.front() == points.back());
  v.require(!repeats, {"points"},
            "each must differ from the one before; a closed boundary does not repeat its first point at the end");
}

}  // namespace

void declare_boundaries(Visitor& v, Recipe& recipe) {
  constexpr Key lines{"boundaries",
                      "Thin rigid boundaries in addition to the walls: hoppers, gates, drums, obstacles, intruders. "
                      "Contacts with them are like those with walls."},
      faces{"boundaries", "The same in space, with `dimension = 3`: boundaries of flat faces."};
  v.when(recipe.dimension == 2, plane, [&](Visitor& outer) {
    outer.list<Boundary>(lines, recipe.boundaries,
                         [&](Visitor& inner, Boundary& boundary) { declare(inner, boundary, recipe); });
  });
  v.when(recipe.dimension == 3, space, [&](Visitor& outer) {
    outer.list<BoundaryIn<3>>(faces, recipe.boundaries_in_space, [&](Visitor& inner, BoundaryIn<3>& boundary) {
      declare_name(inner, boundary.name, recipe.boundaries_in_space);
      declare_faces(inner, boundary, recipe.container);
    });
  });
}

}  // namespace arenite::recipe
