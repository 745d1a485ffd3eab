#pragma once
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/parameters.hpp"
#include "model/shapes.hpp"

namespace arenite::packing {

/// Equal disks that are one rigid grain, in a row or in a ring about its middle.
struct ClumpShape {
  enum class Arrangement { row, ring };
  std::int64_t members = 2;
  Arrangement arrangement = Arrangement::row;
  double aspect = 2;   ///< of a row: length over width
  double spacing = 1;  ///< of a ring: distance of neighbours over the diameter

  static constexpr Word word{"clump", "equal disks, rigidly joined; it may be hollow between them"};
  void declare(ParameterVisitor& visitor) {
    visitor.integer({"members", "How many disks a clump has."}, members, {2, 64});
    visitor.choice({"arrangement", "How they lie."}, arrangement, {{"row", "one behind the other, as long as aspect says"}, {"ring", "evenly on a circle"}});
    visitor.when(arrangement == Arrangement::row, "arrangement = \"row\"", [&](ParameterVisitor& inner) {
      inner.number({"aspect", "Length over width of a clump; with as many as it has members, its disks just touch."}, aspect, "", range::above(1, 64));
      inner.require(aspect <= static_cast<double>(members), {"aspect", "members"}, "must not be above members, or the disks would not touch");
    });
    visitor.when(arrangement == Arrangement::ring, "arrangement = \"ring\"", [&](ParameterVisitor& inner) {
      inner.number({"spacing", "Distance of neighbouring disks' centres over their diameter; at 1 they just touch."}, spacing, "", range::above(0, 1));
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

}  // namespace arenite::packing
