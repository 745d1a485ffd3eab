#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "recipe/keys.hpp"

namespace arenite::recipe {
namespace {

using Visitor = ParameterVisitor;

/// Two numbers, along x and y; none stand for none.
void declare_vector(Visitor& v, const Key& key, std::optional<Vec2>& value, std::string_view unit) {
  std::vector<double> parts;
  if (value) parts = {value->x, value->y};
  v.numbers(key, parts, unit, range::any);
  v.require(parts.empty() || parts.size() == 2, {key.name}, "must be two numbers, along x and along y");
  value = parts.size() == 2 ? std::optional(Vec2{parts[0], parts[1]}) : std::nullopt;
}

bool is_side(const std::string& name) {
  return std::any_of(side_names.begin(), side_names.end(), [&](const char* side) { return name == side; });
}

void declare(Visitor& v, Boundary& boundary, const Recipe& recipe) {
  v.text({"name", "By which stages and results call it: letters, digits, _ and -.", true}, boundary.name);
  v.require(is_plain_name(boundary.name) && !is_side(boundary.name), {"name"}, "must be made of letters, digits, _ and -, and not be that of a wall");
  const auto same = std::count_if(recipe.boundaries.begin(), recipe.boundaries.end(), [&](const Boundary& other) { return other.name == boundary.name; });
  v.require(same <= 1, {"name"}, fmt::format("another boundary is called \"{}\"; names must differ", boundary.name));
  v.points({"points", "Places, from the lower left corner of the container, that straight segments join.", true}, boundary.points, "mm");
  v.flag({"closed", "A segment joins the last point with the first."}, boundary.closed);
  const auto& points = boundary.points;
  v.require(points.size() >= (boundary.closed ? 3u : 2u), {"points"}, boundary.closed ? "must be three or more where closed" : "must be two or more");
  const bool repeats =
      std::adjacent_find(points.begin(), points.end()) != points.end() || (boundary.closed && !points.empty() && points.front() == points.back());
  v.require(!repeats, {"points"}, "each must differ from the one before; a closed boundary does not name its first point again at the end");
}

void declare(Visitor& v, dem::BoundaryMotion& motion, const Stage& stage, const Recipe& recipe) {
  v.text({"name", "Which boundary.", true}, motion.name);
  const auto names = mapped(recipe.boundaries, &Boundary::name);
  const bool known = std::find(names.begin(), names.end(), motion.name) != names.end();
  v.require(known, {"name"},
            names.empty() ? std::string("there are no [[boundaries]] that could move; add them")
                          : fmt::format("there is no boundary \"{}\"; there are: {}", motion.name, fmt::join(names, ", ")));
  const auto same = std::count_if(stage.boundaries.begin(), stage.boundaries.end(), [&](const auto& other) { return other.name == motion.name; });
  v.require(same <= 1, {"name"}, fmt::format("boundary \"{}\" is named twice in this stage", motion.name));
  std::optional<Vec2> velocity = motion.velocity == Vec2{} ? std::nullopt : std::optional(motion.velocity);
  declare_vector(v, {"velocity", "Along x and y."}, velocity, "mm/s");
  motion.velocity = velocity.value_or(Vec2{});
  v.number({"spin", "Rate of turning, counter-clockwise."}, motion.spin, "deg/s", range::any);
  declare_vector(v, {"centre", "About which it turns, as the stage begins; goes with the velocity. Unless given, the mean of the points."}, motion.centre,
                 "mm");
  v.flag({"absent", "It is not there in this stage: a gate that opens."}, motion.absent);
}

}  // namespace

void declare_fill_area(Visitor& v, std::optional<FillArea>& area) {
  v.optional_section<FillArea>({"area", "The part of the container that is filled, where boundaries leave grains no other; needs container.height."}, area,
                               [](Visitor& inner, FillArea& edges) {
                                 inner.number({"left", "Edge, from the container's left side."}, edges.left, "mm", range::not_negative);
                                 inner.number({"right", "Edge, from the container's left side."}, edges.right, "mm", range::positive);
                                 inner.number({"bottom", "Edge, from the container's bottom."}, edges.bottom, "mm", range::not_negative);
                                 inner.number({"top", "Edge, from the container's bottom."}, edges.top, "mm", range::positive);
                               });
}

void require_fill_area(Visitor& v, const Recipe& recipe) {
  const ContainerParameters& frame = recipe.container;
  const auto& area = recipe.packing.area;
  if (!area) return;
  v.require(frame.height > 0, {"container", "packing"}, "a part of it can be filled only where its height is known; write height = \"... mm\"");
  v.require(!frame.periodic_x && !frame.periodic_y, {"packing"}, "packing.area needs a container with four walls");
  const auto fits = [](std::optional<double> low, std::optional<double> high, double size) {
    return low.value_or(0) < high.value_or(size) && high.value_or(size) <= size;
  };
  v.require(fits(area->left, area->right, frame.width) && fits(area->bottom, area->top, frame.height), {"packing"},
            "packing.area must lie in the container, left before right and bottom below top");
}

void declare_boundaries(Visitor& v, Recipe& recipe) {
  v.list<Boundary>(
      {"boundaries", "Thin rigid boundaries beside the walls: hoppers, gates, drums, obstacles, intruders. Contacts with them are like those with walls."},
      recipe.boundaries, [&](Visitor& inner, Boundary& boundary) { declare(inner, boundary, recipe); });
  v.require(recipe.boundaries.empty() || (!recipe.container.periodic_x && !recipe.container.periodic_y), {"boundaries"},
            "need a container with four walls; set container.periodic_x and periodic_y to false");
  require_fill_area(v, recipe);
}

void declare_openings(Visitor& v, Stage& stage, const Recipe& recipe) {
  bool has_open = std::any_of(stage.open.begin(), stage.open.end(), [](bool open) { return open; });
  v.section({"open", "Walls that are taken away in this stage; grains may leave there. One comes back only where no grain is left beyond it."}, has_open,
            [&](Visitor& inner) {
              for (std::size_t side = 0; side < 4; ++side) inner.flag({side_names[side], "This side is open."}, stage.open[side]);
            });
  for (std::size_t side = 0; side < 4; ++side) {
    const bool slides_later =
        std::any_of(stage.programmes.begin(), stage.programmes.end(), [&](const auto& p) { return p.of == dem::Programme::slide + static_cast<int>(side); });
    const bool still = stage.side[side].kind == SideDrive::Kind::fixed && stage.slide[side] == 0 && !slides_later && !stage.rough[side];
    v.require(!stage.open[side] || still, {"open", side_names[side], "slide", "rough"},
              fmt::format("the {} wall cannot be away and move, press or hold grains in one stage", side_names[side]));
    v.require(!stage.open[side] || !(side < bottom ? recipe.container.periodic_x : recipe.container.periodic_y), {"open"},
              fmt::format("there is no wall at the {}: the container is periodic there", side_names[side]));
  }
  v.list<dem::BoundaryMotion>({"boundaries", "How boundaries move in this stage; those that are not named are there, at rest."}, stage.boundaries,
                              [&](Visitor& inner, dem::BoundaryMotion& motion) { declare(inner, motion, stage, recipe); });
  v.number({"count_below", "The history gets the columns `passed` and `passed_mass`: number and mass of the grains whose centre is below this height."},
           stage.count_below, "mm", range::any);
}

}  // namespace arenite::recipe
