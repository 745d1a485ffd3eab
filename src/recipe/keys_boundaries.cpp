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
  v.text({"name", "Name in stages and results: letters, digits, _ and -.", true}, boundary.name);
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
  declare_vector(v, {"centre", "Point about which it turns, as the stage begins; it moves with the velocity. Unless given, the mean of the points."},
                 motion.centre, "mm");
  v.flag({"absent", "The boundary is absent in this stage: a gate that opens."}, motion.absent);
  v.number({"mass", "With a mass it moves under its weight, the force and the grains, starting from the velocity that is given, or from the one that it had."},
           motion.mass, "kg", range::positive);
  std::optional<Vec2> force = motion.force == Vec2{} ? std::nullopt : std::optional(motion.force);
  declare_vector(v, {"force", "Along x and y, on a boundary with a mass."}, force, "N");
  motion.force = force.value_or(Vec2{});
  v.require(motion.mass || motion.force == Vec2{}, {"force", "mass"}, "moves only a boundary with a mass; write mass = \"... kg\"");
  v.require(!motion.mass || recipe.integration.integrator != dem::IntegratorKind::gear5, {"mass"},
            "boundaries with a mass need integration.integrator = \"velocity_verlet\" or \"leapfrog\"");
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
  v.require((!frame.periodic_x || (!area->left && !area->right)) && (!frame.periodic_y || (!area->bottom && !area->top)), {"packing"},
            "packing.area cannot end before a periodic side; leave out its edges there");
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
    v.require(!stage.open[side] || !recipe.container.is_periodic(side), {"open"},
              fmt::format("there is no wall at the {}: the container is periodic there", side_names[side]));
  }
  v.list<dem::BoundaryMotion>({"boundaries", "How boundaries move in this stage; those that are not named are there, at rest."}, stage.boundaries,
                              [&](Visitor& inner, dem::BoundaryMotion& motion) { declare(inner, motion, stage, recipe); });
  v.number({"count_below", "The history gets the columns `passed` and `passed_mass`: number and mass of the grains whose centre is below this height."},
           stage.count_below, "mm", range::any);
}

namespace {

/// Boundaries do not change with a periodic cell.
void require_still_cell(Visitor& v, const Stage& stage, const Recipe& recipe) {
  if (recipe.boundaries.empty()) return;
  bool sheared = stage.shear_rate != 0 || (stage.strain_cycles && stage.strain_cycles->of == dem::StrainCycles::shear);
  for (const auto& p : stage.programmes) sheared = sheared || p.of == dem::Programme::shear_rate;
  v.require(!sheared, {"shear_rate", "strain_cycles", "programmes"}, "a periodic cell with boundaries cannot be sheared; move a boundary or a wall");
  for (std::size_t side = 0; side < 4; ++side) {
    const bool moves = stage.side[side].kind != SideDrive::Kind::fixed || (stage.strain_cycles && stage.strain_cycles->of == static_cast<int>(side));
    v.require(!moves || !recipe.container.is_periodic(side), {side_names[side]},
              "is periodic and cannot move, for boundaries would not fit the cell any more; leave it \"fixed\"");
  }
}

const dem::BoundaryMotion* motion_of(const Stage& stage, const std::string& name) {
  const auto at = std::find_if(stage.boundaries.begin(), stage.boundaries.end(), [&](const auto& motion) { return motion.name == name; });
  return at == stage.boundaries.end() ? nullptr : &*at;
}

void require_boundary(Visitor& v, const dem::Programme& p, const Stage& stage, const Recipe& recipe) {
  const auto known = std::any_of(recipe.boundaries.begin(), recipe.boundaries.end(), [&](const Boundary& b) { return b.name == p.name; });
  v.require(known, {"programmes"}, fmt::format("there is no boundary \"{}\"; name one of [[boundaries]]", p.name));
  const dem::BoundaryMotion* motion = motion_of(stage, p.name);
  const bool free = motion && motion->mass,
             jumps = std::adjacent_find(p.table.begin(), p.table.end(), [](const Vec2&a, const Vec2&b) { return a.x == b.x; }) != p.table.end();
  v.require(p.is_of_force() == free || p.boundary_axis() == 2, {"programmes", "boundaries"},
            free ? fmt::format("boundary \"{}\" has a mass in this stage, so that forces move it; leave its mass out", p.name)
                 : fmt::format("a force moves only a boundary with a mass; write boundaries = [{{ name = \"{}\", mass = \"... kg\" }}] in this stage", p.name));
  v.require(p.is_of_force() || !motion || (motion->velocity == Vec2{} && p.boundary_axis() < 2) || (motion->spin == 0 && p.boundary_axis() == 2),
            {"programmes", "boundaries"},
            fmt::format("boundary \"{}\" moves otherwise in this stage already; leave out its {}", p.name, p.boundary_axis() < 2 ? "velocity" : "spin"));
  v.require(!p.is_of_place() || (!jumps && (!p.repeat || p.table.empty() || p.table.front().y == p.table.back().y)), {"programmes"},
            "a boundary cannot jump: no two rows of one time, and a table that begins anew ends where it began");
}

}  // namespace

void require_boundary_loads(Visitor& v, const Stage& stage, const Recipe& recipe) {
  require_still_cell(v, stage, recipe);
  for (const auto& p : stage.programmes)
    if (p.drives_boundary()) require_boundary(v, p, stage, recipe);
}

}  // namespace arenite::recipe
