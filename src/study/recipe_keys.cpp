#include "study/recipe_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "core/error.hpp"
#include "core/nearest.hpp"
#include "core/units.hpp"
#include "model/domain.hpp"

namespace arenite::study {
namespace {

using Visitor = ParameterVisitor;

void declare(Visitor& v, FrameParameters& frame) {
  v.number({"width", "Inner width of the frame, or of the periodic cell.", true}, frame.width, "mm", range::positive);
  std::optional<double> height = frame.height > 0 ? std::optional(frame.height) : std::nullopt;
  v.number({"height", "Inner height where grains are read from a file; fillings take the one that packing.solid_fraction asks for."},
           height, "mm", range::positive);
  frame.height = height.value_or(0);
  v.number({"thickness", "Length of the cylinders, out of the plane.", true}, frame.thickness, "mm", range::positive);
  v.flag({"periodic_x", "Left and right side are one: no walls there."}, frame.periodic_x);
  v.flag({"periodic_y", "Bottom and top side are one: no walls there."}, frame.periodic_y);
}

void declare(Visitor& v, Material& material) {
  v.number({"density", "Mass density.", true}, material.density, "kg/m^3", range::positive);
  v.number({"stiffness", "Contact stiffness k of two grains of this material.", true}, material.stiffness, "kN/mm",
           range::positive);
  v.number({"thermoelastic_factor", "Temperature rise per fall of the sum of principal stresses; 0: not known."},
           material.thermoelastic_factor, "K/MPa", range::not_negative);
}

void declare(Visitor& v, SizeLaw& law) {
  using Kind = SizeLaw::Kind;
  v.choice({"law", "How diameters are drawn.", true}, law.kind,
           {{"fixed", "one diameter"},
            {"uniform", "evenly between min and max"},
            {"normal", "Gaussian of mean and deviation, cut to min..max"},
            {"list", "the values in turn, from the start again when used up"}});
  v.when(law.kind == Kind::fixed, "law = \"fixed\"", [&](Visitor& inner) {
    inner.number({"diameter", "The diameter.", true}, law.diameter, "mm", range::positive);
  });
  v.when(law.kind == Kind::normal, "law = \"normal\"", [&](Visitor& inner) {
    inner.number({"mean", "Mean diameter before the cut.", true}, law.mean, "mm", range::positive);
    inner.number({"deviation", "Standard deviation before the cut.", true}, law.deviation, "mm", range::not_negative);
  });
  v.when(law.kind == Kind::uniform || law.kind == Kind::normal, "law = \"uniform\" or \"normal\"", [&](Visitor& inner) {
    inner.number({"min", "Smallest diameter.", true}, law.min, "mm", range::positive);
    inner.number({"max", "Largest diameter.", true}, law.max, "mm", range::positive);
    inner.require(law.max >= law.min, {"max", "min"}, "must not be below min");
  });
  v.when(law.kind == Kind::normal, "law = \"normal\"", [&](Visitor& inner) {
    inner.require(law.mean >= law.min && law.mean <= law.max, {"mean", "min", "max"}, "must lie between min and max");
  });
  v.when(law.kind == Kind::list, "law = \"list\"", [&](Visitor& inner) {
    inner.numbers({"values", "The diameters.", true}, law.values, "mm", range::positive);
    inner.require(!law.values.empty(), {"values"}, "must hold at least one diameter");
  });
}

void require_known_material(Visitor& v, const Population& population, const Materials& materials) {
  std::vector<std::string> names;
  for (const auto& material : materials) names.push_back(material.name);
  const bool known = names.empty() || std::find(names.begin(), names.end(), population.material) != names.end();
  const std::string near = nearest(population.material, names);
  v.require(known, {"material"},
            fmt::format("there is no section [materials.{}]; {}", population.material,
                        near.empty() ? "add it" : fmt::format("did you mean \"{}\"?", near)));
}

double largest_diameter(const SizeLaw& law) {
  if (law.kind == SizeLaw::Kind::fixed) return law.diameter;
  if (law.kind == SizeLaw::Kind::list) return law.values.empty() ? 0 : *std::max_element(law.values.begin(), law.values.end());
  return law.max;
}

void declare(Visitor& v, Population& population, const Recipe& recipe) {
  v.text({"material", "Name of a section of [materials].", true}, population.material);
  require_known_material(v, population, recipe.materials);
  v.integer({"count", "Number of grains."}, population.count, {1, 100'000'000});
  v.number({"ratio", "Share by number of packing.grains, relative to the ratios of the other populations."},
           population.ratio, "", range::positive);
  v.require(population.count.has_value() != population.ratio.has_value(), {"ratio", "count"},
            "give either count or ratio");

  auto& size = population.size;
  const bool is_fixed = size.kind == SizeLaw::Kind::fixed;
  std::optional<double> diameter = is_fixed && size.diameter > 0 ? std::optional(size.diameter) : std::nullopt;
  v.number({"diameter", "Diameter of every grain; short for size = { law = \"fixed\", ... }."}, diameter, "mm",
           range::positive);
  if (diameter) size.diameter = *diameter;
  bool has_law = !is_fixed;
  v.section({"size", "Size law of the grains, where they are not all equal."}, has_law,
            [&](Visitor& inner) { declare(inner, size); });
  v.require(diameter.has_value() != has_law, {"size", "diameter"}, "give either diameter or size");
  const double width = recipe.frame.width;
  v.require(width <= 0 || largest_diameter(size) <= width, {"diameter", "size"},
            fmt::format("the largest grain ({}) is wider than the frame ({})",
                        format_quantity(largest_diameter(size), "mm"), format_quantity(width, "mm")));
}

void declare(Visitor& v, PackingParameters& packing) {
  using Method = PackingParameters::Method;
  v.choice({"method", "How the grains get their first places."}, packing.method,
           {{"random", "at random, then relaxed until overlaps vanish"},
            {"lattice", "stacked row on row as a triangular lattice"},
            {"file", "as a CSV of centres, radii and materials says"}});
  v.when(packing.method != Method::file, "method = \"random\" or \"lattice\"", [&](Visitor& inner) {
    inner.integer({"grains", "Total number of grains, where populations give ratios."}, packing.grains, {0, 100'000'000});
  });
  v.when(packing.method == Method::random, "method = \"random\"", [&](Visitor& inner) {
    inner.number({"solid_fraction", "Area share of the grains that the random filling aims at; loading compacts it."},
                 packing.solid_fraction, "", range::above(0, 0.9));
  });
  v.when(packing.method == Method::file, "method = \"file\"", [&](Visitor& inner) {
    inner.file({"file", "CSV of the grains: id, x, y, radius, material.", true}, packing.file);
  });
}

void declare(Visitor& v, dem::ContactParameters& contact) {
  v.choice({"normal", "Normal force at an overlap h."}, contact.normal,
           {{"linear", "spring k_eff h and dashpot"}, {"hertz", "spring growing with h^(3/2)"}});
  v.choice({"stiffness_rule", "Stiffness of a contact of two materials."}, contact.stiffness_rule,
           {{"thesis", "k for like grains, k_i k_j/(k_i + k_j) for unlike ones"},
            {"series", "two springs in series, of 2 k_i and 2 k_j"}});
  v.choice({"wall_stiffness", "Stiffness of a contact with a wall."}, contact.wall_stiffness,
           {{"stiffest", "that of the stiffest material"}, {"grain", "that of the grain"}, {"series", "by the series rule"}});
  v.number({"restitution", "Ratio of speeds after and before a head-on collision; sets the damping of each pair."},
           contact.restitution, "", range::above(0, 1));
  v.number({"normal_damping", "Damping coefficient alpha_n of every pair, instead of the one that restitution asks for."},
           contact.normal_damping, "N s/m", range::not_negative);
  v.flag({"attractive_dashpot", "Damping may pull at separation; false: contacts without adhesion never pull."},
         contact.attractive_dashpot);
  v.choice({"friction_law", "Tangential force."}, contact.friction_law,
           {{"none", "smooth grains"},
            {"regularised_coulomb", "-min(gamma_s |v_s|, mu |F_n|) sign(v_s): no friction at true rest"},
            {"cundall_strack", "spring with Coulomb's cap: holds static friction"}});
  v.number({"friction", "Coefficient mu between grains."}, contact.friction, "", range::not_negative);
  v.number({"wall_friction", "Coefficient mu at the walls; unless given, that of the grains."}, contact.wall_friction, "",
           range::not_negative);
  v.number({"sliding_viscosity", "gamma_s of the regularised law; unless given, the normal damping of the pair."},
           contact.sliding_viscosity, "N s/m", range::not_negative);
  v.number({"tangential_stiffness_ratio", "k_t/k_n of the Cundall-Strack spring."}, contact.tangential_stiffness_ratio, "",
           range::positive);
  v.choice({"arms", "Lever arms of contact forces."}, contact.arms,
           {{"contact_point", "to the middle of the overlap"}, {"full_radius", "the radii"}});
  v.choice({"adhesion", "Adhesion between glued grains."}, contact.adhesion,
           {{"none", "no glue"},
            {"geometrical", "-gamma sqrt(r_eff h), reversible"},
            {"geometrical_breaking", "the same, lost for good once a contact opens"}});
  v.number({"surface_energy", "gamma of the adhesion."}, contact.surface_energy, "kN/mm", range::not_negative);
  v.require(contact.adhesion == dem::Adhesion::none || contact.surface_energy > 0, {"surface_energy", "adhesion"},
            "must be above 0 kN/mm where adhesion acts");
  v.choice({"effective_radius", "r_eff of the adhesion."}, contact.effective_radius,
           {{"four_reduced", "4 r_i r_j/(r_i + r_j)"}, {"sum", "r_i + r_j"}, {"geometric_mean", "2 sqrt(r_i r_j)"}});
  v.choice({"friction_cap", "Coulomb's cap where adhesion pulls."}, contact.friction_cap,
           {{"raised_by_adhesion", "mu (F_n + |F_c|)"}, {"as_printed", "mu (F_n - |F_c|)"}});
  v.pairs({"glued_pairs", "Pairs of grains (indices from 0) that are glued, instead of all pairs in the glued region."},
          contact.glued_pairs);
}

void declare(Visitor& v, dem::IntegrationParameters& integration) {
  v.choice({"integrator", "Scheme for Newton's equations."}, integration.integrator,
           {{"velocity_verlet", "second order, the sturdiest"},
            {"leapfrog", "second order, velocities half a step off"},
            {"gear5", "Gear's fifth-order predictor and corrector; needs small steps where damping is strong"}});
  v.number({"time_step", "Time step; one beyond the stable step is refused. Unless given, safety sets it."},
           integration.time_step, "s", range::positive);
  v.number({"safety", "Time step as a share of the shortest contact time, pi sqrt(m_eff/k)."}, integration.safety, "",
           range::above(0, 1));
  v.flag({"rotations", "Grains turn; false: they only move."}, integration.rotations);
  v.number({"drag", "Global viscous drag, as a rate: the force on a grain is -drag m v."}, integration.drag, "1/s",
           range::not_negative);
  v.flag({"track_energy", "Account for dissipation and work at every step (slower)."}, integration.track_energy);
  // A name from elsewhere (--kernel) comes here without having been read, so it may be none of these.
  static const std::vector<std::string> kernels{"auto", "portable", "avx2", "avx512"};
  const auto found = std::find(kernels.begin(), kernels.end(), integration.kernel);
  if (found == kernels.end()) {
    throw InputError(fmt::format("there is no kernel \"{}\"; take one of: {}", integration.kernel, fmt::join(kernels, ", ")));
  }
  int kernel = static_cast<int>(found - kernels.begin());
  v.choice({"kernel", "Machine code of the contact loop."}, kernel,
           {{"auto", "the fastest of this processor"},
            {"portable", "the same bits on every x86-64 processor"},
            {"avx2", "256-bit vectors"},
            {"avx512", "512-bit vectors"}});
  integration.kernel = kernels[static_cast<std::size_t>(kernel)];
}

void declare(Visitor& v, Region& region, const FrameParameters& frame) {
  v.number({"x", "Centre, from the left side.", true}, region.x, "mm", range::not_negative);
  v.number({"y", "Centre, from the bottom.", true}, region.y, "mm", range::not_negative);
  v.require(frame.width <= 0 || region.x <= frame.width, {"x"}, "must lie inside the frame");
  v.require(frame.height <= 0 || region.y <= frame.height, {"y"}, "must lie inside the frame");
  v.integer({"count", "The grains nearest to the centre, this many, instead of a shape."}, region.count, {1, 100'000'000});
  v.when(!region.count, "no count", [&](Visitor& inner) {
    inner.choice({"shape", "Outline; grains whose centre lies inside are glued."}, region.shape,
                 {{"circle", "of a radius"}, {"rectangle", "of width and height"}});
  });
  v.when(!region.count && region.shape == Region::Shape::circle, "shape = \"circle\"", [&](Visitor& inner) {
    inner.number({"radius", "Radius of the circle.", true}, region.radius, "mm", range::positive);
  });
  v.when(!region.count && region.shape == Region::Shape::rectangle, "shape = \"rectangle\"", [&](Visitor& inner) {
    inner.number({"width", "Width of the rectangle.", true}, region.width, "mm", range::positive);
    inner.number({"height", "Height of the rectangle.", true}, region.height, "mm", range::positive);
  });
}

void declare(Visitor& v, RestCriterion& rest) {
  v.number({"unbalanced", "Unbalanced force ratio below this."}, rest.unbalanced, "", range::positive);
  v.number({"kinetic", "Kinetic over elastic energy below this."}, rest.kinetic, "", range::positive);
  std::optional<double> mobilisation = rest.mobilisation >= 0 ? std::optional(rest.mobilisation) : std::nullopt;
  v.number({"mobilisation", "Mean |F_t|/F_n below this as well, if given: tells creep from rest where friction is viscous."},
           mobilisation, "", range::not_negative);
  rest.mobilisation = mobilisation.value_or(-1);
  v.integer({"max_steps", "Steps of one increment, after which the run stops with exit status 3."}, rest.max_steps,
            {1, 1'000'000'000'000});
}

void declare(Visitor& v, Cycles& cycles) {
  int side = static_cast<int>(std::find(side_names.begin(), side_names.end(), cycles.side) - side_names.begin());
  if (side == 4) side = bottom;
  v.choice({"side", "The side that cycles."}, side, {{"left", ""}, {"right", ""}, {"bottom", ""}, {"top", ""}});
  cycles.side = side_names[static_cast<std::size_t>(side)];
  v.number({"min", "Force at the end of each cycle.", true}, cycles.min, "kN", range::not_negative);
  v.number({"max", "Force in the middle of each cycle.", true}, cycles.max, "kN", range::positive);
  v.require(cycles.max > cycles.min, {"max", "min"}, "must be above min");
  v.integer({"count", "Number of cycles.", true}, cycles.count, {1, 1'000'000});
  v.integer({"increments", "Increments of each half cycle."}, cycles.increments, {1, 1'000'000});
}

void require_usable_sides(Visitor& v, const Stage& stage, const FrameParameters& frame) {
  using Kind = SideDrive::Kind;
  bool moves = false;
  for (int side = 0; side < 4; ++side) {
    const auto kind = stage.side[static_cast<std::size_t>(side)].kind;
    const bool periodic = side < 2 ? frame.periodic_x : frame.periodic_y;
    v.require(!periodic || (kind != Kind::force && kind != Kind::pressure), {side_names[static_cast<std::size_t>(side)]},
              fmt::format("a periodic side has no wall to press; leave it fixed, move it, or set frame.periodic_{} = false",
                          side < 2 ? "x" : "y"));
    moves = moves || kind == Kind::velocity;
  }
  v.require(!moves || stage.duration, {"duration", "left", "right", "bottom", "top"},
            "a stage with a moving side never comes to rest; give it a duration, for example duration = \"1 s\"");
  if (!stage.cycles) return;
  const auto side = std::find(side_names.begin(), side_names.end(), stage.cycles->side) - side_names.begin();
  v.require(stage.side[static_cast<std::size_t>(side)].kind == Kind::force, {"cycles", side_names[static_cast<std::size_t>(side)]},
            fmt::format("cycles need a side under force; write {} = {{ force = \"...\" }} in this stage", stage.cycles->side));
}

bool is_plain_name(const std::string& name) {
  return !name.empty() && std::all_of(name.begin(), name.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-';
  });
}

/// Names that stand in a column of a CSV.
bool is_label(const std::string& name) {
  return !name.empty() && std::none_of(name.begin(), name.end(), [](unsigned char c) {
    return c < ' ' || c == 127 || c == ',' || c == '"' || c == '\'' || c == ';';
  });
}

void declare(Visitor& v, Stage& stage, const Recipe& recipe) {
  v.text({"name", "Name of the stage, used for its file: letters, digits, _ and -.", true}, stage.name);
  v.require(is_plain_name(stage.name), {"name"}, "must be made of letters, digits, _ and -");
  const auto same = std::count_if(recipe.stages.begin(), recipe.stages.end(),
                                  [&](const Stage& other) { return &other != &stage && other.name == stage.name; });
  v.require(same == 0, {"name"}, fmt::format("another stage is called \"{}\"; names must differ", stage.name));
  v.flag({"gravity", "Grains weigh (9.81 m/s^2 downwards)."}, stage.gravity);
  for (std::size_t side = 0; side < 4; ++side) {
    auto& drive = stage.side[side];
    int form = static_cast<int>(drive.kind);
    v.tagged({side_names[side], "What this side does."}, form, drive.value,
             {{"fixed", "", "stays where it is", range::any},
              {"velocity", "mm/s", "moves inward at this speed", range::any},
              {"force", "kN", "presses on the sample, reached in the stage's increments", range::not_negative},
              {"pressure", "kPa", "presses on the sample, acting in full at once", range::not_negative}});
    drive.kind = static_cast<SideDrive::Kind>(form);
  }
  v.integer({"increments", "Equal steps in which forces are reached, each ending at rest."}, stage.increments, {1, 1'000'000});
  v.number({"duration", "Time after which the stage ends, whether at rest or not; needed where a side moves."},
           stage.duration, "s", range::positive);
  v.integer({"frames", "States stored during a stage with a duration; other stages store one an increment."}, stage.frames,
            {1, 1'000'000});
  v.number({"friction", "Coefficient mu during this stage only, for example 0 to densify."}, stage.friction, "",
           range::not_negative);
  v.number({"drag", "Additional viscous drag during this stage only, as a rate."}, stage.drag, "1/s", range::not_negative);
  v.flag({"glue", "Adhesion acts from this stage on."}, stage.glue);
  v.require(!stage.glue || recipe.contact.adhesion != dem::Adhesion::none, {"glue"},
            "there is nothing to glue with; set contact.adhesion and contact.surface_energy");
  v.optional_section<Cycles>({"cycles", "Force cycles on one side after the ramp."}, stage.cycles,
                             [](Visitor& inner, Cycles& cycles) { declare(inner, cycles); });
  v.section({"rest", "When an increment counts as done."}, [&](Visitor& inner) { declare(inner, stage.rest); });
  require_usable_sides(v, stage, recipe.frame);
}

void declare_materials(Visitor& v, Materials& materials) {
  v.sections({"materials", "Constitutive materials of the grains, by name.", true},
             {[&] { return materials.size(); }, [&](std::size_t n) { materials.resize(n); },
              [&](Visitor& inner, std::size_t i) {
                inner.require(is_label(materials[i].name), {},
                              "a material's name must not be empty or hold commas, quotes or control characters");
                declare(inner, materials[i]);
              },
              [&](std::size_t i) -> std::string& { return materials[i].name; }});
}

void require_grains(Visitor& v, const Recipe& recipe) {
  using Method = PackingParameters::Method;
  const auto& populations = recipe.populations;
  const bool from_file = recipe.packing.method == Method::file;
  v.require(from_file || !populations.empty(), {"populations", "packing"},
            "is missing; say which grains there are in [[populations]], or read them with packing.method = \"file\"");
  v.require(!from_file || populations.empty(), {"populations", "packing"},
            "the grains come from packing.file; leave out [[populations]], or choose another packing.method");
  v.require(!from_file || recipe.frame.height > 0, {"frame"}, "grains from a file need a height; write height = \"... mm\"");
  const bool shares = std::any_of(populations.begin(), populations.end(), [](const auto& p) { return p.ratio.has_value(); });
  std::int64_t counted = 0;
  for (const auto& population : populations) counted += population.count.value_or(0);
  v.require(!shares || recipe.packing.grains > counted, {"packing", "populations"},
            fmt::format("populations with a ratio share packing.grains less the {} counted grains; set it higher", counted));
}

}  // namespace

void declare(ParameterVisitor& v, Recipe& recipe) {
  v.text({"title", "One line for the head of reports."}, recipe.title);
  std::int64_t seed = static_cast<std::int64_t>(recipe.seed);
  v.integer({"seed", "Seed of all random numbers: the same seed gives the same sample."}, seed,
            {0, std::numeric_limits<std::int64_t>::max()});
  recipe.seed = static_cast<std::uint64_t>(seed);
  v.section({"frame", "The frame that holds the grains.", true}, [&](Visitor& inner) { declare(inner, recipe.frame); });
  declare_materials(v, recipe.materials);
  v.list<Population>({"populations", "Grains of one material and one size law."}, recipe.populations,
                     [&](Visitor& inner, Population& population) { declare(inner, population, recipe); });
  v.section({"packing", "How the grains are put into the frame."}, [&](Visitor& inner) { declare(inner, recipe.packing); });
  require_grains(v, recipe);
  v.section({"contact", "Forces between grains, and between grains and walls."},
            [&](Visitor& inner) { declare(inner, recipe.contact); });
  v.section({"integration", "Newton's equations in time."}, [&](Visitor& inner) { declare(inner, recipe.integration); });
  v.optional_section<Region>({"glued", "A region whose grains are glued to each other."}, recipe.glued,
                             [&](Visitor& inner, Region& region) { declare(inner, region, recipe.frame); });
  v.require(!recipe.glued || recipe.contact.adhesion != dem::Adhesion::none, {"glued", "contact"},
            "there is nothing to glue with; set contact.adhesion and contact.surface_energy");
  v.list<Stage>({"stages", "Loading, stage after stage; each starts where the one before ended.", true}, recipe.stages,
                [&](Visitor& inner, Stage& stage) { declare(inner, stage, recipe); });
}

}  // namespace arenite::study
