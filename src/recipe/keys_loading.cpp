#include <fmt/core.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/mapped.hpp"
#include "core/text.hpp"
#include "grains/dem/integrators/integrators.hpp"
#include "model/packing.hpp"
#include "recipe/keys.hpp"

namespace arenite::recipe {

void declare(Visitor& v, dem::ContactParameters& contact) {
  v.member({"normal", "Normal force at an overlap h."}, contact.normal);
  v.choice({"stiffness_rule", "Stiffness of a contact of two materials."}, contact.stiffness_rule,
           {{"thesis", "k for like grains, k_i k_j/(k_i + k_j) for unlike ones"}, {"series", "two springs in series, of 2 k_i and 2 k_j"}});
  v.choice({"wall_stiffness", "Stiffness of a contact with a wall."}, contact.wall_stiffness,
           {{"stiffest", "that of the stiffest material"}, {"grain", "that of the grain"}, {"series", "by the series rule"}});
  v.number({"restitution", "Ratio of speeds after and before a head-on collision; sets the damping of each pair."}, contact.restitution, "",
           range::above(0, 1));
  v.number({"normal_damping", "Damping coefficient alpha_n of every pair, instead of the one that follows from restitution."}, contact.normal_damping, "N s/m",
           range::not_negative);
  v.flag({"attractive_dashpot", "The dashpot may attract while grains separate; false: contacts without adhesion are never tensile."},
         contact.attractive_dashpot);
  v.member({"friction_law", "Tangential force."}, contact.friction_law);
  v.number({"friction", "Coefficient mu between grains."}, contact.friction, "", range::not_negative);
  v.number({"wall_friction", "Coefficient mu at the walls; unless given, that of the grains."}, contact.wall_friction, "", range::not_negative);
  v.number({"sliding_viscosity", "gamma_s, tangential damping coefficient of the friction law; if not given, the normal damping of the pair."},
           contact.sliding_viscosity, "N s/m", range::not_negative);
  v.number({"tangential_stiffness_ratio", "k_t/k_n, for friction laws with a tangential spring."}, contact.tangential_stiffness_ratio, "", range::positive);
  v.member({"rolling", "Moment between two grains that rotate relative to each other."}, contact.rolling);
  v.member({"bonds", "Cement between two grains, from the stage that creates it."}, contact.bonds);
  v.member({"cohesion", "Attraction between all grains, touching or not: adhesion without glue, or liquid bridges."}, contact.cohesion);
  v.choice({"arms", "Lever arms of contact forces."}, contact.arms, {{"contact_point", "to the middle of the overlap"}, {"full_radius", "the radii"}});
  v.member({"adhesion", "Adhesion between glued grains."}, contact.adhesion);
  v.number({"surface_energy", "gamma of the adhesion."}, contact.surface_energy, "kN/mm", range::not_negative);
  v.require(!contact.adheres() || contact.surface_energy > 0, {"surface_energy", "adhesion"}, "must be above 0 kN/mm where adhesion acts");
  v.choice({"effective_radius", "r_eff of the adhesion."}, contact.effective_radius,
           {{"four_reduced", "4 r_i r_j/(r_i + r_j)"}, {"sum", "r_i + r_j"}, {"geometric_mean", "2 sqrt(r_i r_j)"}});
  v.choice({"friction_cap", "Coulomb limit in the presence of adhesion."}, contact.friction_cap,
           {{"raised_by_adhesion", "mu (F_n + |F_c|)"}, {"as_printed", "mu (F_n - |F_c|)"}});
  v.pairs({"glued_pairs", "Pairs of grains (indices from 0) that are glued, instead of all pairs in the glued region."}, contact.glued_pairs);
}

void declare(Visitor& v, dem::IntegrationParameters& integration) {
  v.choice({"integrator", "Scheme for Newton's equations."}, integration.integrator, mapped(dem::integrators, &dem::Integrator::word));
  v.number({"time_step", "Time step; an unstable one is refused. Unless given, safety sets it, and the masses of a stage may shorten it."},
           integration.time_step, "s", range::positive);
  v.number({"safety", "Time step as a fraction of the shortest contact time, pi sqrt(m_eff/k)."}, integration.safety, "", range::above(0, 1));
  v.flag({"rotations", "Grains rotate; false: they only translate."}, integration.rotations);
  v.flag({"track_energy", "Compute dissipation and work at every step (slower)."}, integration.track_energy);
  // A name from elsewhere (--kernel) comes here without having been read, so it may be none of these.
  static const std::vector<std::string> kernels{"auto", "portable", "avx2", "avx512"};
  const auto found = std::find(kernels.begin(), kernels.end(), integration.kernel);
  if (found == kernels.end()) { throw InputError(fmt::format("there is no kernel \"{}\"; choose one of: {}", integration.kernel, list_of(kernels))); }
  int kernel = static_cast<int>(found - kernels.begin());
  v.choice({"kernel", "Machine code of the contact loop."}, kernel,
           {{"auto", "the fastest on this processor"},
            {"portable", "the same bits on every x86-64 processor"},
            {"avx2", "256-bit vectors"},
            {"avx512", "512-bit vectors"}});
  integration.kernel = kernels[static_cast<std::size_t>(kernel)];
}

namespace {

void declare(Visitor& v, EquilibriumCriterion& criterion) {
  v.number({"unbalanced", "Unbalanced force ratio below this."}, criterion.unbalanced, "", range::positive);
  v.number({"kinetic", "Kinetic over elastic energy below this."}, criterion.kinetic, "", range::positive);
  v.number({"falling", "Fraction of grains that still fall (gravity, fewer than two compressive contacts) not above this."}, criterion.falling, "",
           range::not_negative);
  v.number({"loose_kinetic",
            "Kinetic energy of the grains that carry no load (fewer than two compressive contacts) over elastic energy below this; a hundred thousand times "
            "`kinetic` unless given, because without gravity only rare collisions slow them."},
           criterion.loose_kinetic, "", range::positive);
  v.number({"mobilisation", "Mean |F_t|/F_n below this as well, if given: distinguishes creep from equilibrium where friction is viscous."},
           criterion.mobilisation, "", range::not_negative);
  v.integer({"max_steps", "Steps of one increment, after which the run stops with exit status 3."}, criterion.max_steps, {1, 1'000'000'000'000});
}

void declare(Visitor& v, Cycles& cycles) {
  v.choice({"side", "The side that cycles."}, cycles.side, {{"left", ""}, {"right", ""}, {"bottom", ""}, {"top", ""}});
  v.number({"min", "Force at the end of each cycle.", true}, cycles.min, "kN", range::not_negative);
  v.number({"max", "Force in the middle of each cycle.", true}, cycles.max, "kN", range::positive);
  v.require(cycles.max > cycles.min, {"max", "min"}, "must be above min");
  v.integer({"count", "Number of cycles.", true}, cycles.count, {1, 1'000'000});
  v.integer({"increments", "Increments of each half cycle."}, cycles.increments, {1, 1'000'000});
  declare_store_every(v, cycles.store_every);
}

bool presses(const SideDrive& drive) { return drive.kind == SideDrive::Kind::force || drive.kind == SideDrive::Kind::pressure; }

/// A section with a value for each of the four sides.
void declare_sides(Visitor& v, const Key& key, const std::function<void(Visitor&, std::size_t)>& one) {
  v.section(key, [&](Visitor& inner) {
    for (std::size_t side = 0; side < 4; ++side) one(inner, side);
  });
}

/// A force on an edge of a periodic cell moves that edge and strains the cell; with the opposite edge free as well, the
/// cell would drift.
void require_one_pressing_edge(Visitor& v, const Stage& stage, std::size_t first, bool periodic) {
  const SideDrive &one = stage.side[first], &other = stage.side[first + 1];
  const char *name = side_names[first], *opposite = side_names[first + 1];
  const bool both_at_work = (presses(one) && other.kind != SideDrive::Kind::fixed) || (presses(other) && one.kind != SideDrive::Kind::fixed);
  v.require(!periodic || !both_at_work, {opposite, name},
            fmt::format("of the two periodic edges {0} and {1} one is under pressure and the other fixed; leave {0} = \"fixed\"", name, opposite));
}

void require_usable_sides(Visitor& v, const Stage& stage, const ContainerParameters& frame) {
  using Kind = SideDrive::Kind;
  require_one_pressing_edge(v, stage, left, frame.periodic[0]);
  require_one_pressing_edge(v, stage, bottom, frame.periodic[1]);
  v.require(!stage.gravity || !frame.periodic[1], {"gravity"}, "grains would fall for ever through periodic sides; set container.periodic_y = false");
  const bool moves = std::ranges::count(stage.side, Kind::velocity, &SideDrive::kind) > 0 || stage.slide != std::array<double, 4>{} || stage.shear_rate != 0 ||
                     std::ranges::any_of(stage.boundaries, [](const auto& b) { return b.velocity != Vec2{} || b.spin != 0; });
  v.require(stage.shear_rate == 0 || (frame.periodic[0] && frame.periodic[1]), {"shear_rate"},
            "only a cell periodic in both directions can be sheared in this way; set container.periodic_x and periodic_y, or let a wall slide");
  for (std::size_t side = 0; side < 4; ++side)
    v.require((stage.slide[side] == 0 && !stage.rough[side]) || !frame.is_periodic(side), {"slide", "rough"},
              fmt::format("there is no wall at the {}: the container is periodic there", side_names[side]));
  v.require(!moves || stage.duration, {"duration", "left", "right", "bottom", "top", "boundaries"},
            "a stage with a moving side or boundary never reaches equilibrium; give it a duration, for example duration = \"1 s\"");
  if (!stage.cycles) return;
  const auto side = static_cast<std::size_t>(stage.cycles->side);
  v.require(stage.side[side].kind == Kind::force, {"cycles", side_names[side]},
            fmt::format("cycles need a side under force; write {} = {{ force = \"...\" }} in this stage", side_names[side]));
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
    inner.number({"gravity_angle", "Angle of gravity from straight down, counter-clockwise."}, stage.gravity_angle, "deg", range::any);
  });
  declare_sides(v, {"slide", "Walls that slide in their own plane; positive: left and right upwards, bottom and top to the right."},
                [&](Visitor& inner, std::size_t side) {
                  inner.number({side_names[side], "Sliding velocity."}, stage.slide[side], "mm/s", range::any);
                });
  declare_sides(v, {"rough", "Rough walls: grains nearer than half their radius at the start of the stage move with the wall."},
                [&](Visitor& inner, std::size_t side) {
                  inner.flag({side_names[side], "This wall is rough."}, stage.rough[side]);
                });
  v.number({"shear_rate", "Shear rate du_x/dy of a cell that is periodic in x and y (Lees and Edwards); its top and bottom may also apply a pressure."},
           stage.shear_rate, "1/s", range::any);
  for (std::size_t side = 0; side < 4; ++side) {
    auto& drive = stage.side[side];
    int form = static_cast<int>(drive.kind);
    v.tagged(
        {side_names[side], "Motion of this side, or the force on it."}, form, drive.value,
        {{"fixed", "", "stays where it is", range::any},
         {"velocity", "mm/s", "moves inward at this speed", range::any},
         {"force", "kN", "presses on the sample, reached in the stage's increments; of two periodic edges one presses and one is fixed", range::not_negative},
         {"pressure", "kPa", "presses on the sample, acting in full at once; of two periodic edges one presses and one is fixed", range::not_negative}});
    drive.kind = static_cast<SideDrive::Kind>(form);
  }
  declare_programmes(v, stage, recipe);
  declare_openings(v, stage, recipe);
  v.integer({"increments", "Equal steps in which forces are applied, each ending in equilibrium."}, stage.increments, {1, 1'000'000});
  v.number({"duration", "Time after which the stage ends, whether in equilibrium or not; needed where a side moves."}, stage.duration, "s", range::positive);
  v.integer({"snapshots", "States stored during a stage with a duration; other stages store one per increment.", false, "frames"}, stage.snapshots,
            {1, 1'000'000});
  v.number({"friction", "Coefficient mu during this stage only, for example 0 to densify."}, stage.friction, "", range::not_negative);
  v.number({"drag", "Viscous drag during this stage, as a rate: the force on a grain is -drag m v."}, stage.drag, "1/s", range::not_negative);
  v.number({"critical_drag",
            "Additional drag, as a fraction of the rate that critically damps the slowest wave of a crystal of this size. About 0.2 brings a jammed packing of "
            "any size "
            "to equilibrium fastest; it hinders rearrangement, so compact without it first."},
           stage.critical_drag, "", range::not_negative);
  v.choice({"mass_scaling",
            "Masses of the grains in the equations of motion of this stage. Without friction, equilibria do not depend on them; with friction they depend on "
            "the path.",
            false, "masses"},
           stage.mass_scaling,
           {{"none", "their own", "own"},
            {"uniform", "such that k/m of all grains equals the largest one: a polydisperse sample compacts in far fewer steps; not with gravity", "even"}});
  v.require(!stage.gravity || stage.mass_scaling == dem::MassScaling::none, {"mass_scaling", "gravity"},
            "gravity acts on the true masses; leave gravity or mass_scaling out");
  v.number({"inertial_number",
            "Inertial number that limits the speed of a side under force or pressure, over sqrt(force times width over mass): larger compacts faster and "
            "overshoots more; 1 suits a compaction at P/k of 1e-3 or less."},
           stage.inertial_number, "", range::positive);
  v.flag({"glue", "Adhesion acts from this stage on."}, stage.glue);
  v.require(!stage.glue || recipe.contact.adheres(), {"glue"}, "no adhesion is defined; set contact.adhesion and contact.surface_energy");
  v.flag({"bond", "Grains that touch, or nearly (bond_gap), at the start of the stage are bonded; if glued grains are marked, only those."}, stage.bond);
  v.require(!stage.bond || recipe.contact.has_bonds(), {"bond"}, "no bonds are defined; set contact.bonds = \"parallel\"");
  v.optional_section<Cycles>({"cycles", "Force cycles on one side after the ramp."}, stage.cycles,
                             [](Visitor& inner, Cycles& cycles) { declare(inner, cycles); });
  declare_strain_cycles(v, stage, recipe);
  require_boundary_loads(v, stage, recipe);
  v.section({"equilibrium", "Criteria that end an increment.", false, "rest"}, [&](Visitor& inner) { declare(inner, stage.equilibrium); });
  require_usable_sides(v, stage, recipe.container);
}

}  // namespace arenite::recipe
