#include <fmt/format.h>

#include <algorithm>

#include "recipe/recipe_key_parts.hpp"
#include "recipe/recipe_words.hpp"

namespace arenite::study {
namespace {

using Visitor = ParameterVisitor;

void declare(Visitor& v, StiffnessSection& stiffness) {
  v.number({"matrix", "Young's modulus of bonds between two nodes of matrix."}, stiffness.matrix, "GPa", range::positive);
  v.number({"interface", "That of bonds between two grains, or grain and matrix; unless given, the matrix's."}, stiffness.interface, "GPa",
           range::positive);
  v.number({"particle", "That of bonds inside a grain; unless given, four times the matrix's."}, stiffness.particle, "GPa", range::positive);
  v.flag({"calibrated", "The lattice's modulus along its axes is the one asked for; false: the continuum's formula, 6 % stiffer."},
         stiffness.calibrated);
}

void declare(Visitor& v, ToughnessSection& toughness) {
  v.number({"matrix", "Fracture toughness of the matrix; it sets the scale of the load."}, toughness.matrix, "MPa m^0.5", range::positive);
  v.number({"interface", "That of the interfaces; unless given, the matrix's."}, toughness.interface, "MPa m^0.5", range::positive);
  v.number({"particle", "That of the grains; unless given, 3.5 times the matrix's."}, toughness.particle, "MPa m^0.5", range::positive);
}

void declare(Visitor& v, stress::StressOptions& statistics) {
  std::int64_t rows = statistics.clamp_rows;
  v.integer({"clamp_rows", "Rows of nodes left out at the lower and the upper edge."}, rows, {0, 10'000});
  statistics.clamp_rows = static_cast<int>(rows);
  v.flag({"leave_out_surface", "Leave out nodes with a neighbour of another phase or grain."}, statistics.leave_out_surface);
  v.flag({"leave_out_unloaded", "Leave out nodes without any stress: parts that nothing ties to both edges."}, statistics.leave_out_unloaded);
  v.flag({"mean_over_area", "The sample's mean counts the void as zero stress; otherwise it is that of particles and matrix."},
         statistics.mean_over_area);
}

void require_own_name(Visitor& v, const Load& load, const Recipe& recipe) {
  v.require(is_plain_name(load.name), {"name"}, "must be made of letters, digits, _ and -");
  const auto same_load = std::count_if(recipe.loads.begin(), recipe.loads.end(),
                                       [&](const Load& other) { return &other != &load && other.name == load.name; });
  const auto same_stage = std::count_if(recipe.stages.begin(), recipe.stages.end(), [&](const Stage& s) { return s.name == load.name; });
  v.require(same_load + same_stage == 0, {"name"}, fmt::format("another stage or load is called \"{}\"; names must differ", load.name));
}

}  // namespace

void declare(ParameterVisitor& v, Load& load, const Recipe& recipe) {
  using peridynamics::Loading;
  v.text({"name", "Name of the load, used for its file: letters, digits, _ and -.", true}, load.name);
  require_own_name(v, load, recipe);
  v.choice({"loading", "How the top row is moved against the bottom row."}, load.loading, words(load.loading));
  v.choice({"axis", "Axis that runs from the bottom row to the top row; x loads the sample turned."}, load.axis, words(load.axis));
  v.choice({"lower", "What holds the bottom row."}, load.lower, words(load.lower));
  v.require(load.loading != Loading::shear || load.lower == peridynamics::LowerEdge::fixed, {"lower", "loading"},
            "a lower edge that slides carries no shear; fix it, or choose tension or compression");
  v.flag({"failure", "Load until it breaks: bonds break at the critical stretch of their type, load by load. In compression a sample splits and goes on carrying; max_strain ends it."}, load.failure);
  v.when(!load.failure, "failure = false", [&](Visitor& inner) {
    inner.number({"strain", "Displacement of the top row over the height."}, load.strain, "", range::above(0, 0.5));
    inner.choice({"method", "Way to the field at equilibrium."}, load.method, words(load.method));
    inner.flag({"exact_stretch", "Stretch of the turned bond, as printed in the paper; otherwise linearised."}, load.exact_stretch);
    inner.flag({"moduli", "Load along both axes and in shear, too, for moduli and Poisson's ratios of the sample."}, load.moduli);
    inner.integer({"max_iterations", "Iterations after which a solve gives up; 0: 50, or a million steps of dynamics."}, load.max_iterations,
                  {0, 1'000'000'000});
  });
  v.number({"tolerance", "Residual, relative to that of uniform strain, at which a field is at equilibrium."}, load.tolerance, "",
           range::between(1e-12, 0.1));
  v.when(load.failure, "failure = true", [&](Visitor& inner) {
    inner.number({"max_strain", "The pull ends at this strain,"}, load.max_strain, "", range::above(0, 1));
    inner.number({"end_stress", "or when the stress has fallen to this share of the largest."}, load.end_stress, "", range::above(0, 1));
    inner.number({"band", "Bonds within this share of the most overstretched break in one round: larger is faster and coarser."}, load.band, "",
                 range::between(0, 1));
    inner.section({"toughness", "At which stretch bonds break."}, [&](Visitor& section) { declare(section, load.toughness); });
  });
  v.section({"stiffness", "Young's moduli of the bonds by type."}, [&](Visitor& inner) { declare(inner, load.stiffness); });
  v.section({"statistics", "Which nodes the statistics leave out."}, [&](Visitor& inner) { declare(inner, load.statistics); });
}

}  // namespace arenite::study
