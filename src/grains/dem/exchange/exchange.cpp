#include "grains/dem/exchange/exchange.hpp"

#include <string_view>

#include "core/parameters.hpp"

namespace arenite::dem {
namespace {

void declare_velocity(ParameterVisitor& v, std::string_view sentence, Vec2& velocity) {
  std::vector<double> parts;
  if (velocity != Vec2{}) parts = {velocity.x, velocity.y};
  v.numbers({"velocity", sentence}, parts, "m/s", range::any);
  v.require(parts.empty() || parts.size() == 2, {"velocity"}, "must be two numbers, along x and along y");
  if (parts.size() == 2) velocity = {parts[0], parts[1]};
}

}  // namespace

void Area::declare(ParameterVisitor& v) {
  v.number({"left", "Edge, from the container's left side."}, left, "mm", range::any);
  v.number({"right", "Edge, from the container's left side."}, right, "mm", range::any);
  v.number({"bottom", "Edge, from the container's bottom."}, bottom, "mm", range::any);
  v.number({"top", "Edge, from the container's bottom."}, top, "mm", range::any);
  v.require(!left || !right || *left <= *right, {"right", "left"}, "must not be left of left");
  v.require(!bottom || !top || *bottom <= *top, {"top", "bottom"}, "must not be below bottom");
}

void Inflow::declare(ParameterVisitor& v) {
  area.declare(v);
  v.number({"rate", "Grains per time."}, rate, "1/s", range::positive);
  v.number({"mass_rate", "Mass per time, instead of rate."}, mass_rate, "kg/s", range::positive);
  v.require(rate.has_value() != mass_rate.has_value(), {"rate", "mass_rate"}, "give either rate or mass_rate");
  declare_velocity(v, "Of the grains as they come in, along x and y; unless given, they are at rest.", velocity);
  v.text({"material",
          "Only grains of the populations of this material; unless given, of all populations. They come in the shares "
          "of the populations' numbers."},
         material);
  v.integer({"count", "The inflow ends after so many grains."}, count, {1, 1'000'000'000});
}

void Outlet::declare(ParameterVisitor& v) {
  area.declare(v);
  v.require(area.is_bounded(), {"top", "bottom", "left", "right"},
            "is missing; give an edge at least, for example top = \"10 mm\" for all that is below");
  v.optional_section<Area>(
      {"recycle_to",
       "The grains are put back in this area, as grains with new ids, as soon as there is room; until then they stay "
       "where they are."},
      recycle_to, [](ParameterVisitor& inner, Area& area) { area.declare(inner); });
  v.when(recycle_to.has_value(), "recycle_to", [&](ParameterVisitor& inner) {
    declare_velocity(inner, "Of the grains as they are put back, along x and y; unless given, they are at rest.",
                     velocity);
  });
}

}  // namespace arenite::dem
