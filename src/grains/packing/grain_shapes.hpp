#pragma once
#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>
#include <variant>

#include "core/parameters.hpp"
#include "model/shapes.hpp"

namespace arenite::packing {

struct DiskShape {
  static constexpr Word word{"disk", "a disk"};
  void declare(ParameterVisitor& /*visitor*/) {}
  bool operator==(const DiskShape&) const = default;

  Shape make() const { return {{{}}, {1}, false}; }
};

/// Equal disks that are one rigid grain, in a row or in a ring about its middle.
struct ClumpShape {
  enum class Arrangement { row, ring };
  std::int64_t members = 2;
  Arrangement arrangement = Arrangement::row;
  double aspect = 2;   ///< of a row: length over width
  double spacing = 1;  ///< of a ring: distance of neighbours over the diameter

  static constexpr Word word{"clump", "equal disks, rigidly joined, possibly with a hole between them"};
  void declare(ParameterVisitor& visitor) {
    visitor.integer({"members", "Number of disks of a clump."}, members, {2, 64});
    visitor.choice({"arrangement", "Arrangement of the disks."}, arrangement,
                   {{"row", "in a line, with the aspect ratio `aspect`"}, {"ring", "evenly on a circle"}});
    visitor.when(arrangement == Arrangement::row, "arrangement = \"row\"", [&](ParameterVisitor& inner) {
      inner.number({"aspect", "Length over width of a clump; if equal to members, its disks just touch."}, aspect, "",
                   range::above(1, 64));
      inner.require(aspect <= static_cast<double>(members), {"aspect", "members"},
                    "must not be above members, or the disks would not touch");
    });
    visitor.when(arrangement == Arrangement::ring, "arrangement = \"ring\"", [&](ParameterVisitor& inner) {
      inner.number({"spacing", "Distance of neighbouring disks' centres over their diameter; at 1 they just touch."},
                   spacing, "", range::above(0, 1));
      inner.require(members >= 3, {"members", "arrangement"}, "a ring needs 3 members or more");
    });
  }
  bool operator==(const ClumpShape&) const = default;

  Shape make() const {
    Shape shape;
    const auto n = static_cast<double>(members);
    for (std::int64_t k = 0; k < members; ++k) {
      const auto at = static_cast<double>(k);
      const double around = spacing / std::sin(std::numbers::pi / n);
      shape.place.push_back(arrangement == Arrangement::row ? Vec2{2 * (aspect - 1) * (at / (n - 1) - 0.5), 0}
                                                            : around * direction(2 * std::numbers::pi * at / n));
      shape.radius.push_back(1);
    }
    return shape;
  }
};

/// A regular polygon, perhaps stretched, with rounded corners.
struct PolygonShape {
  std::int64_t corners = 4;
  double aspect = 1;      ///< stretch along one axis
  double rounding = 0.1;  ///< radius of the corners over that of the disk of the grain's area

  static constexpr Word word{"polygon", "a regular convex polygon with rounded corners"};
  void declare(ParameterVisitor& visitor) {
    visitor.integer({"corners", "Number of corners of a polygon."}, corners, {3, 64});
    declare_form(visitor);
  }
  void declare_form(ParameterVisitor& visitor) {
    visitor.number({"aspect", "Stretch along one of its axes; 1: regular."}, aspect, "", range::between(1, 20));
    visitor.number(
        {"rounding", "Radius of the corners over that of the disk of equal area; small values need stiff contacts."},
        rounding, "", range::between(0.01, 0.5));
  }
  bool operator==(const PolygonShape&) const = default;

  /// With the area of a disk of radius 1: A s^2 + P s r + pi r^2 = pi for the polygon's own area A and length P.
  Shape make() const {
    Shape shape;
    shape.filled = true;
    const auto n = static_cast<std::size_t>(corners);
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 at = direction(2 * std::numbers::pi * (static_cast<double>(k) + 0.5) / static_cast<double>(n));
      shape.place.push_back({aspect * at.x, at.y});
    }
    double area = 0, length = 0;
    for (std::size_t k = 0; k < n; ++k) {
      const Vec2 from = shape.place[k], to = shape.place[(k + 1) % n];
      area += 0.5 * cross(from, to);
      length += norm(to - from);
    }
    const double half = 0.5 * length * rounding, rest = std::numbers::pi * (1 - rounding * rounding);
    const double scale = (std::sqrt(half * half + area * rest) - half) / area;
    for (Vec2& p : shape.place) p = scale * p;
    shape.radius.assign(n, rounding);
    return shape;
  }
};

/// A polygon by its name.
template <int Corners> struct NamedPolygon : PolygonShape {
  static constexpr Word word = Corners == 3   ? Word{"triangle", "an equilateral triangle with rounded corners"}
                               : Corners == 4 ? Word{"square", "a square with rounded corners"}
                               : Corners == 5 ? Word{"pentagon", "a regular pentagon with rounded corners"}
                                              : Word{"hexagon", "a regular hexagon with rounded corners"};
  NamedPolygon() { corners = Corners; }
  void declare(ParameterVisitor& visitor) { declare_form(visitor); }
  bool operator==(const NamedPolygon&) const = default;
};

/// What a family of shapes gives: its word in recipes, its own parameters, equality, and a shape, of any size and
/// anywhere.
template <class S>
concept MakesShapes = std::default_initializable<S> && std::equality_comparable<S> &&
    requires(S shape, ParameterVisitor& visitor) {
  { S::word } -> std::convertible_to<Word>;
  { shape.declare(visitor) } -> std::same_as<void>;
  { shape.make() } -> std::same_as<Shape>;
};
template <MakesShapes... Each> using GrainShapes = std::variant<Each...>;

/// The shapes there are, the usual one first. A new one is a struct beside these and a word here: recipe keys, their
/// documentation and hashes follow.
using GrainShape = GrainShapes<DiskShape, ClumpShape, PolygonShape, NamedPolygon<3>, NamedPolygon<4>, NamedPolygon<5>,
                               NamedPolygon<6>>;

}  // namespace arenite::packing
