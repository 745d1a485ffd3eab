#include "recipe/keys/stages.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <functional>
#include <string>

#include "core/error.hpp"
#include "core/text.hpp"
#include "grains/dem/membranes/membranes.hpp"
#include "grains/dem/parts/rough_walls.hpp"
#include "grains/fields/regime/prediction.hpp"
#include "grains/fields/regime/until.hpp"
#include "model/packing.hpp"
#include "recipe/keys/boundaries.hpp"
#include "recipe/keys/exchange.hpp"
#include "recipe/keys/membranes.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

namespace {

/// Something for each of the sides of the plane, and in space for those at the back and the front.
using OfSide = std::function<void(Visitor&, std::size_t)>;
void declare_every_side(Visitor& v, bool in_space, const OfSide& one) {
  for (std::size_t side = 0; side < sides; ++side) one(v, side);
  v.when(in_space, space, [&](Visitor& inner) {
    for (const std::size_t side : {back, front}) one(inner, side);
  });
}

/// What is wrong with the condition that ends a stage; empty where nothing is.
std::string problem_of_until(const Stage& stage, const Recipe& recipe) {
  if (stage.until.empty()) return {};
  Domain domain;
  DomainIn<3> vessel;
  for (const Boundary& boundary : recipe.boundaries) domain.boundaries.emplace_back().name = boundary.name;
  for (const auto& boundary : recipe.boundaries_in_space) vessel.boundaries.emplace_back().name = boundary.name;
  for (int side = 0; side < sides; ++side)
    if (stage.side[side].is_skin()) domain.boundaries.emplace_back().name = dem::membrane_name(side);
  const bool bonded = recipe.contact.has_bonds(), cohesive = recipe.contact.is_cohesive();
  try {
    fields::Until(stage.until)
        .check(recipe.dimension == 3 ? fields::history_numbers_in_space(stage, vessel, bonded, cohesive)
                                     : fields::history_numbers(stage, domain, bonded, cohesive));
  } catch (const InputError& error) { return error.what(); }
  return {};
}

void declare_until(Visitor& v, Stage& stage, const Recipe& recipe) {
  v.text({"until",
          "Condition on numbers of the stage's history or on its curves that ends it before its duration or its "
          "increments do: \"axial_strain > 20 %\", \"q < 0.5*max(q)\" (half of the largest so far), "
          "\"discharge_rate < 10 1/s\"; `and` and `or` join several. What is to be below a limit must have been as "
          "large as it before. It is looked at with each row of the history."},
         stage.until);
  const std::string problem = problem_of_until(stage, recipe);
  v.require(problem.empty(), {"until"}, problem);
}

/// A time step that is given tells how many steps there are before anything is made.
void require_countable_steps(Visitor& v, const Stage& stage, const Recipe& recipe) {
  if (!recipe.integration.time_step) return;
  const std::string wrong = fields::too_many_steps(stage, *recipe.integration.time_step);
  v.require(wrong.empty(), {"duration", "strain_cycles"}, wrong + ", or raise integration.time_step");
}

/// What the sides of the sample do.
void declare_walls(Visitor& v, Stage& stage, bool in_space) {
  v.section(
      {"slide", "Walls that slide in their own plane; positive: left and right upwards, the others to the right."},
      [&](Visitor& section) {
        declare_every_side(section, in_space, [&](Visitor& inner, std::size_t side) {
          inner.number({any_side_names[side], "Sliding velocity."}, stage.slide[side], "mm/s", range::any);
        });
      });
  static const std::string rough =
      fmt::format("Rough walls: grains nearer than {} of their radius at the start of the stage move with the wall.",
                  dem::rough_reach);
  v.section({"rough", rough}, [&](Visitor& section) {
    declare_every_side(section, in_space, [&](Visitor& inner, std::size_t side) {
      inner.flag({any_side_names[side], "This wall is rough."}, stage.rough[side]);
    });
  });
  v.number({"shear_rate",
            "Shear rate du_x/dy of a cell that is periodic in x and y (Lees and Edwards); its top and bottom may also "
            "apply a pressure."},
           stage.shear_rate, "1/s", range::any);
  declare_every_side(v, in_space, [&](Visitor& inner, std::size_t side) {
    auto& drive = stage.side[side];
    int form = static_cast<int>(drive.kind);
    inner.tagged(
        {any_side_names[side], "Motion of this side, or the force on it."}, form, drive.value,
        {{"fixed", "", "stays where it is", range::any},
         {"velocity", "mm/s", "moves inward at this speed", range::any},
         {"force", "kN",
          "presses on the sample, reached in the stage's increments; of two periodic edges one presses and one is "
          "fixed",
          range::not_negative},
         {"pressure", "kPa",
          "presses on the sample, acting in full at once; of two periodic edges one presses and one is fixed",
          range::not_negative},
         {"membrane", "kPa",
          "becomes a flexible membrane with this pressure outside, held by the walls beside it ([membrane])",
          range::not_negative}});
    drive.kind = static_cast<SideDrive::Kind>(form);
  });
}

/// What grains are held back by as they move, and what they weigh.
void declare_motion(Visitor& v, Stage& stage) {
  v.number({"friction", "Coefficient mu during this stage only, for example 0 to densify."}, stage.friction, "",
           range::not_negative);
  v.number({"drag", "Viscous drag during this stage, as a rate: the force on a grain is -drag m v."}, stage.drag, "1/s",
           range::not_negative);
  v.number({"critical_drag",
            "Additional drag, as a fraction of the rate that critically damps the slowest wave of a crystal of this "
            "size. About 0.2 brings a jammed packing of any size to equilibrium fastest; it hinders rearrangement, so "
            "compact without it first."},
           stage.critical_drag, "", range::not_negative);
  v.choice({"mass_scaling",
            "Masses of the grains in the equations of motion of this stage. Without friction, equilibria do not depend "
            "on them; with friction they depend on the path.",
            false, "masses"},
           stage.mass_scaling,
           {{"none", "their own", "own"},
            {"uniform",
             "such that k/m of all grains equals the largest one: a polydisperse sample compacts in far fewer steps; "
             "not with gravity",
             "even"}});
  v.require(!stage.gravity || stage.mass_scaling == dem::MassScaling::none, {"mass_scaling", "gravity"},
            "gravity acts on the true masses; leave gravity or mass_scaling out");
  v.number({"inertial_number",
            "Speed to which a side under force or pressure is damped where nothing else drives the sample, over "
            "sqrt(force times width over mass): larger compacts faster and overshoots more; 1 suits a compaction at "
            "P/k of 1e-3 or less. Where something drives the sample at least 1 is used."},
           stage.inertial_number, "", range::positive);
}

/// What joins grains from this stage on.
void declare_joints(Visitor& v, Stage& stage, const Recipe& recipe) {
  v.flag({"glue", "Adhesion acts from this stage on."}, stage.glue);
  v.require(!stage.glue || recipe.contact.adheres(), {"glue"},
            "no adhesion is defined; set contact.adhesion and contact.surface_energy");
  v.flag({"bond",
          "Grains that touch, or nearly (bond_gap), at the start of the stage are bonded; if glued grains are marked, "
          "only those."},
         stage.bond);
  v.require(!stage.bond || recipe.contact.has_bonds(), {"bond"},
            "no bonds are defined; set contact.bonds = \"parallel\"");
}

}  // namespace

void declare(Visitor& v, Stage& stage, const Recipe& recipe) {
  v.text({"name", "Name of the stage, used for its file: letters, digits, _ and -.", true}, stage.name);
  v.require(is_plain_name(stage.name), {"name"}, "must be made of letters, digits, _ and -");
  v.require(std::ranges::count(recipe.stages, stage.name, &Stage::name) <= 1, {"name"},
            fmt::format("another stage is called \"{}\"; names must differ", stage.name));
  v.flag({"gravity", "Gravity acts on the grains."}, stage.gravity);
  v.when(stage.gravity, "gravity = true", [&](Visitor& inner) {
    inner.number({"gravity_size", "Acceleration of gravity."}, stage.gravity_size, "m/s^2", range::not_negative);
    inner.number({"gravity_angle", "Angle of gravity from straight down, counter-clockwise."}, stage.gravity_angle,
                 "deg", range::any);
  });
  declare_walls(v, stage, recipe.dimension == 3);
  declare_programmes(v, stage, recipe);
  declare_openings(v, stage, recipe);
  v.integer({"increments", "Equal steps in which forces are applied, each ending in equilibrium."}, stage.increments,
            {1, 1'000'000});
  v.number({"duration", "Time after which the stage ends, whether in equilibrium or not; needed where a side moves."},
           stage.duration, "s", range::above(0, 1e9));
  v.integer({"snapshots", "States stored during a stage with a duration; other stages store one per increment.", false,
             "frames"},
            stage.snapshots, {1, 1'000'000});
  declare_until(v, stage, recipe);
  declare_motion(v, stage);
  declare_joints(v, stage, recipe);
  declare_cycles(v, stage, recipe);
  require_boundary_loads(v, stage, recipe);
  declare_exchange(v, stage, recipe);
  v.section({"equilibrium", "Criteria that end an increment.", false, "rest"},
            [&](Visitor& inner) { stage.equilibrium.declare(inner); });
  require_countable_steps(v, stage, recipe);
  require_usable_sides(v, stage, recipe.container);
  require_membranes(v, stage, recipe);
}

}  // namespace arenite::recipe
