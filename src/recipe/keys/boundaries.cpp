#include "recipe/keys/boundaries.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "recipe/keys.hpp"
#include "recipe/keys/stages.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

namespace {

using dem::Programme;

/// The motion of one of these boundaries among those of a stage.
template <int D>
void declare_motion(Visitor& v, dem::BoundaryMotionIn<D>& motion, const Stage& stage,
                    const std::vector<BoundaryIn<D>>& boundaries, const Recipe& recipe) {
  motion.declare(v);
  const auto names = mapped(boundaries, &BoundaryIn<D>::name);
  v.require(std::ranges::count(names, motion.name) > 0, {"name"},
            names.empty() ? std::string("there are no [[boundaries]] that could move; add them")
                          : fmt::format("there is no boundary \"{}\"; there are: {}", motion.name, list_of(names)));
  v.require(std::ranges::count(dem::boundaries_in<D>(stage), motion.name, &dem::BoundaryMotionIn<D>::name) <= 1,
            {"name"}, fmt::format("boundary \"{}\" is named twice in this stage", motion.name));
  v.require(!motion.mass || dem::integrator_of(recipe.integration.integrator).moves_bodies, {"mass"},
            "boundaries with a mass need integration.integrator = " + dem::integrators_of_bodies());
}

/// Samples in the plane have no back and no front.
void require_side(Visitor& v, int side, std::string_view key, const Recipe& recipe) {
  v.require(side < (recipe.dimension == 3 ? sides_in<3> : sides_in<2>), {key},
            fmt::format("the {} side is of samples in space; take dimension = 3, or one of: left, right, bottom, top",
                        any_side_names[static_cast<std::size_t>(side)]));
}

/// Boundaries do not change with a periodic cell.
void require_still_cell(Visitor& v, const Stage& stage, const Recipe& recipe) {
  if (recipe.boundaries.empty() && recipe.boundaries_in_space.empty()) return;
  const bool sheared =
      stage.shear_rate != 0 || (stage.strain_cycles && stage.strain_cycles->of == dem::StrainCycles::shear) ||
      std::ranges::count(stage.programmes, dem::Driven{Programme::What::shear_rate}, &Programme::of) > 0;
  v.require(!sheared, {"shear_rate", "strain_cycles", "programmes"},
            "a periodic cell with boundaries cannot be sheared; move a boundary or a wall");
  for (std::size_t side = 0; side < stage.side.size(); ++side) {
    const bool moves = stage.side[side].kind != SideDrive::Kind::fixed ||
                       (stage.strain_cycles && stage.strain_cycles->of == static_cast<int>(side));
    v.require(!moves || !recipe.container.is_periodic(side), {any_side_names[side]},
              "is periodic and cannot move, because the boundaries would no longer fit the cell; leave it \"fixed\"");
  }
}

template <int D>
void require_boundary(Visitor& v, const Programme& p, const std::vector<BoundaryIn<D>>& there,
                      const std::vector<dem::BoundaryMotionIn<D>>& motions) {
  v.require(std::ranges::count(there, p.name, &BoundaryIn<D>::name) > 0, {"programmes"},
            fmt::format("there is no boundary \"{}\"; name one of [[boundaries]]", p.name));
  const auto at = std::ranges::find(motions, p.name, &dem::BoundaryMotionIn<D>::name);
  const dem::BoundaryMotionIn<D>* motion = at == motions.end() ? nullptr : &*at;
  const bool free = motion && motion->mass, jumps = std::ranges::adjacent_find(p.table, {}, &Vec2::x) != p.table.end();
  v.require(
      p.of.is_of_force() == free || p.of.turns(), {"programmes", "boundaries"},
      free ? fmt::format("boundary \"{}\" has a mass in this stage, so that forces move it; leave its mass out", p.name)
           : fmt::format("a force moves only a boundary with a mass; write boundaries = [{{ name = \"{}\", mass = "
                         "\"... kg\" }}] in this stage",
                         p.name));
  v.require(
      p.of.is_of_force() || !motion || (p.of.turns() ? motion->spin == Turning<D>{} : motion->velocity == Vec<D>{}),
      {"programmes", "boundaries"},
      fmt::format("the motion of boundary \"{}\" is already prescribed in this stage; leave out its {}", p.name,
                  p.of.turns() ? "spin" : "velocity"));
  v.require(
      !p.of.is_of_force() || !motion || p.of.way() >= D || motion->force[p.of.way()] == 0, {"programmes", "boundaries"},
      fmt::format("the force on boundary \"{}\" along this axis is already prescribed in this stage; write 0 for it "
                  "there",
                  p.name));
  v.require(!p.of.is_of_place() || (!jumps && (!p.repeat || p.table.empty() || p.table.front().y == p.table.back().y)),
            {"programmes"},
            "a boundary cannot jump: no two rows may have the same time, and a repeated table must end where it began");
}

/// Where a stage keeps what a programme of sides, slides, shear or gravity drives.
double& constant_of(const dem::Driven& of, Stage& stage) {
  if (of.is_of_side()) return stage.side[static_cast<std::size_t>(of.side)].value;
  if (of.is(Programme::What::slide)) return stage.slide[static_cast<std::size_t>(of.side)];
  if (of.is(Programme::What::shear_rate)) return stage.shear_rate;
  return of.is(Programme::What::gravity_size) ? stage.gravity_size : stage.gravity_angle;
}

/// The first value of a programme is that of the stage itself, so that what looks at a stage knows what it begins with.
void begin_with(const Programme& p, Stage& stage) {
  constant_of(p.of, stage) = p.table.front().y;
  if (!p.of.is_of_side()) return;
  SideDrive& side = stage.side[static_cast<std::size_t>(p.of.side)];
  if (!side.is_skin()) side.kind = p.of.kind();
}

void require_place(Visitor& v, const Programme& p, const Stage& stage, const Recipe& recipe) {
  const auto& container = recipe.container;
  v.require(recipe.dimension == 3 || !p.of.is_of_space(), {"of"},
            fmt::format("\"{}\" is of samples in space; take dimension = 3, or drive something of the plane",
                        dem::programme_targets[dem::target_of(p.of)].word));
  if (p.of.is_of_side()) {
    const SideDrive& side = stage.side[static_cast<std::size_t>(p.of.side)];
    v.require(!side.is_skin() || p.of.is(Programme::What::pressure), {"of"},
              fmt::format("the {0} side is a membrane, and what changes with time is its pressure; write of = "
                          "\"{0}.pressure\"",
                          any_side_names[p.of.side]));
    v.require(side.kind == SideDrive::Kind::fixed || side.is_skin() || side.kind == p.of.kind(), {"of"},
              fmt::format("the {} side is already driven in this stage; leave out \"{}\" there",
                          any_side_names[p.of.side], any_side_names[p.of.side]));
  } else if (p.of.is(Programme::What::slide)) {
    const int side = p.of.side;
    v.require(!container.is_periodic(side), {"of"},
              fmt::format("there is no wall at the {}: the container is periodic there", any_side_names[side]));
  } else if (p.of.is(Programme::What::shear_rate)) {
    v.require(container.periodic[0] && container.periodic[1], {"of"},
              "only a cell periodic in both directions can be sheared in this way");
  } else if (!p.of.is_of_boundary()) {
    v.require(stage.gravity, {"of"}, "there is no gravity in this stage; write gravity = true");
  }
}

/// A force on an edge of a periodic cell moves that edge and strains the cell; with the opposite edge free as well, the
/// cell would drift.
void require_one_pressing_edge(Visitor& v, const Stage& stage, std::size_t first, bool periodic) {
  const SideDrive &one = stage.side[first], &other = stage.side[first + 1];
  const char *name = any_side_names[first], *opposite = any_side_names[first + 1];
  const bool both_at_work = (one.presses() && other.kind != SideDrive::Kind::fixed) ||
                            (other.presses() && one.kind != SideDrive::Kind::fixed);
  v.require(
      !periodic || !both_at_work, {opposite, name},
      fmt::format(
          "of the two periodic edges {0} and {1} one is under pressure and the other fixed; leave {0} = \"fixed\"",
          name, opposite));
}

/// In space their velocities, spins and forces have three components.
void declare_motions(Visitor& v, Stage& stage, const Recipe& recipe) {
  constexpr Key in_plane{"boundaries", "Motion of boundaries in this stage; boundaries not listed stay in place."},
      in_space{"boundaries", "The same in space, with `dimension = 3`."};
  v.when(recipe.dimension == 2, plane, [&](Visitor& outer) {
    outer.list<dem::BoundaryMotion>(in_plane, stage.boundaries, [&](Visitor& inner, dem::BoundaryMotion& motion) {
      declare_motion(inner, motion, stage, recipe.boundaries, recipe);
    });
  });
  v.when(recipe.dimension == 3, space, [&](Visitor& outer) {
    outer.list<dem::BoundaryMotionIn<3>>(in_space, stage.boundaries_in_space,
                                         [&](Visitor& inner, dem::BoundaryMotionIn<3>& motion) {
                                           declare_motion(inner, motion, stage, recipe.boundaries_in_space, recipe);
                                         });
  });
}

}  // namespace

void declare_openings(Visitor& v, Stage& stage, const Recipe& recipe) {
  bool has_open = std::ranges::count(stage.open, true) > 0;
  v.section({"open",
             "Walls that are removed in this stage; grains may leave there. A wall can be restored only if no grain is "
             "left beyond it."},
            has_open, [&](Visitor& inner) {
              for (std::size_t side = 0; side < 4; ++side)
                inner.flag({side_names[side], "This side is open."}, stage.open[side]);
              inner.when(recipe.dimension == 3, space, [&](Visitor& deep) {
                for (const std::size_t side : {back, front})
                  deep.flag({any_side_names[side], "This side is open."}, stage.open[side]);
              });
            });
  for (std::size_t side = 0; side < stage.open.size(); ++side) {
    const bool slides_later =
        std::ranges::count(stage.programmes, dem::Driven{Programme::What::slide, static_cast<int>(side)},
                           &Programme::of) > 0;
    const bool still = stage.side[side].kind == SideDrive::Kind::fixed && stage.slide[side] == 0 && !slides_later &&
                       !stage.rough[side];
    v.require(
        !stage.open[side] || still, {"open", any_side_names[side], "slide", "rough"},
        fmt::format("the {} wall cannot be open and move, press or carry grains in one stage", any_side_names[side]));
    v.require(!stage.open[side] || !recipe.container.is_periodic(side), {"open"},
              fmt::format("there is no wall at the {}: the container is periodic there", any_side_names[side]));
  }
  declare_motions(v, stage, recipe);
  v.number({"count_below",
            "The history gets the columns `passed` and `passed_mass`: number and mass of the grains whose centre is "
            "below this height."},
           stage.count_below, "mm", range::any);
}

void require_usable_sides(Visitor& v, const Stage& stage, const ContainerParameters& container) {
  using Kind = SideDrive::Kind;
  require_one_pressing_edge(v, stage, left, container.periodic[0]);
  require_one_pressing_edge(v, stage, bottom, container.periodic[1]);
  require_one_pressing_edge(v, stage, back, container.periodic[2]);
  v.require(!stage.gravity || !container.periodic[1], {"gravity"},
            "grains would fall for ever through periodic sides; set container.periodic_y = false");
  const bool moves = std::ranges::count(stage.side, Kind::velocity, &SideDrive::kind) > 0 ||
                     stage.slide != ByAnySide<double>{} || stage.shear_rate != 0 || dem::moves_boundaries(stage);
  v.require(stage.shear_rate == 0 || (container.periodic[0] && container.periodic[1]), {"shear_rate"},
            "only a cell periodic in both directions can be sheared in this way; set container.periodic_x and "
            "periodic_y, or let a wall slide");
  for (std::size_t side = 0; side < stage.slide.size(); ++side)
    v.require((stage.slide[side] == 0 && !stage.rough[side]) || !container.is_periodic(side), {"slide", "rough"},
              fmt::format("there is no wall at the {}: the container is periodic there", any_side_names[side]));
  v.require(!moves || stage.duration, {"duration", "left", "right", "bottom", "top", "boundaries"},
            "a stage with a moving side or boundary never reaches equilibrium; give it a duration, for example "
            "duration = \"1 s\"");
  if (!stage.cycles) return;
  const auto side = static_cast<std::size_t>(stage.cycles->side);
  const char* load = stage.cycles->of_pressure ? "pressure" : "force";
  v.require(stage.side[side].kind == stage.cycles->kind(), {"cycles", any_side_names[side]},
            fmt::format("cycles need a side under {0}; write {1} = {{ {0} = \"...\" }} in this stage", load,
                        any_side_names[side]));
}

void require_boundary_loads(Visitor& v, const Stage& stage, const Recipe& recipe) {
  require_still_cell(v, stage, recipe);
  for (const auto& p : stage.programmes)
    if (!p.of.is_of_boundary()) continue;
    else if (recipe.dimension == 3) require_boundary(v, p, recipe.boundaries_in_space, stage.boundaries_in_space);
    else require_boundary(v, p, recipe.boundaries, stage.boundaries);
}

void declare_programmes(Visitor& v, Stage& stage, const Recipe& recipe) {
  v.list<Programme>(
      {"programmes",
       "Tables in time that drive the stage, which then needs a duration. They are followed step by step."},
      stage.programmes, [&](Visitor& inner, Programme& p) {
        p.declare(inner);
        require_place(inner, p, stage, recipe);
      });
  for (auto at = stage.programmes.begin(); at != stage.programmes.end(); ++at) {
    const Programme& p = *at;
    const bool again = std::any_of(stage.programmes.begin(), at, [&](const Programme& other) {
      if (p.of.is_of_boundary())
        return other.of.is_of_boundary() && other.name == p.name && other.of.way() == p.of.way();
      return other.of == p.of || (p.of.is_of_side() && other.of.is_of_side() && other.of.side == p.of.side);
    });
    v.require(!again, {"programmes"},
              fmt::format("{} is driven by two of them", dem::programme_targets[dem::target_of(p.of)].word));
    if (p.table.empty() || p.of.is_of_boundary()) continue;
    const bool is_of_gravity = p.of.is(Programme::What::gravity_size) || p.of.is(Programme::What::gravity_angle);
    const double constant = constant_of(p.of, stage);
    v.require(again || is_of_gravity || constant == 0 || constant == p.table.front().y, {"programmes"},
              fmt::format("{} has a constant of its own in this stage, and the table begins with another value; leave "
                          "the constant out",
                          dem::programme_targets[dem::target_of(p.of)].word));
    begin_with(p, stage);
  }
}

void declare_cycles(Visitor& v, Stage& stage, const Recipe& recipe) {
  v.optional_section<dem::Cycles>({"cycles", "Cycles of force or pressure on one side after the ramp."}, stage.cycles,
                                  [&](Visitor& inner, dem::Cycles& cycles) {
                                    cycles.declare(inner);
                                    require_side(inner, cycles.side, "side", recipe);
                                  });
  v.optional_section<dem::StrainCycles>(
      {"strain_cycles",
       "Cycles between two strains, each half at a constant rate; they end the stage. The first half starts from the "
       "initial strain and ends at `max`."},
      stage.strain_cycles, [&](Visitor& inner, dem::StrainCycles& cycles) {
        cycles.declare(inner);
        const auto of = static_cast<std::size_t>(cycles.of);
        if (cycles.of == dem::StrainCycles::shear) {
          inner.require(recipe.container.periodic[0] && recipe.container.periodic[1], {"of"},
                        "only a cell periodic in both directions can be sheared in this way");
          return;
        }
        require_side(inner, cycles.of, "of", recipe);
        inner.require(
            stage.side[of].kind == SideDrive::Kind::fixed, {"of"},
            fmt::format("the {} side is already driven in this stage; leave it \"fixed\"", any_side_names[of]));
      });
  v.require(!stage.strain_cycles || !stage.duration, {"duration", "strain_cycles"},
            "strain cycles end the stage; leave out its duration");
  v.require(!stage.strain_cycles || (!stage.cycles && stage.programmes.empty()),
            {"strain_cycles", "cycles", "programmes"}, "only one of them can drive a stage");
  v.require(stage.programmes.empty() || stage.duration, {"programmes", "duration"},
            "a stage with programmes needs its duration, for example duration = \"1 s\"");
  v.require(stage.programmes.empty() || !stage.cycles, {"programmes", "cycles"}, "only one of them can drive a stage");
}

}  // namespace arenite::recipe
