#include <fmt/core.h>

#include <algorithm>

#include "recipe/keys.hpp"
#include "recipe/recipe.hpp"

namespace arenite::recipe {

std::vector<Word> words(cement::CementParameters::Kind) {
  return {{"none", "nowhere"},
          {"bridges", "trapezia between neighbouring grains"},
          {"full", "in all space between the grains"},
          {"coating", "a layer of uniform thickness around every grain"},
          {"menisci", "between two arcs that touch both neighbours, like a liquid"}};
}

std::vector<Word> words(peridynamics::Loading) { return {{"tension", "away from it"}, {"compression", "towards it"}, {"shear", "along it, to the right"}}; }

std::vector<Word> words(peridynamics::LowerEdge) { return {{"fixed", "nothing moves"}, {"sliding", "free along the row"}}; }

std::vector<Word> words(peridynamics::Method) {
  return {{"static_solve", "conjugate gradients with a coarse space divided by grain: seconds"},
          {"relaxation", "adaptive dynamic relaxation: half a minute"},
          {"damped", "dynamics with a fixed viscosity, as in the paper: minutes"}};
}

std::vector<Word> words(Load::Axis) { return {{"y", ""}, {"x", ""}}; }

std::vector<Word> words(grid::Cavity) { return {{"pore", "space between grains, matrix or empty"}, {"void", "empty space"}}; }

namespace {

void declare(Visitor& v, BidisperseSection& classes, const Materials& materials) {
  auto& law = classes.law;
  v.number({"large_radius", "Mean radius of the large disks.", true}, law.large_radius, "mm", range::positive);
  v.number({"size_ratio", "gamma: ratio of the mean radii of large and small disks."}, law.size_ratio, "", range::between(1, 20));
  v.number({"volume_ratio", "theta: ratio of the areas of large and small disks."}, law.volume_ratio, "", range::above(0, 100));
  v.number({"deviation", "Standard deviation of each class over its mean radius."}, law.deviation, "", range::between(0, 0.5));
  v.number({"truncation", "Radii are truncated at this many standard deviations.", false, "cut"}, law.cut, "", range::above(0, 1.9));
  v.flag({"truncate_each_class", "Each class is truncated separately; otherwise both to their common range.", false, "cut_each_class"}, law.cut_each_class);
  v.flag({"hold_radius", "A radius is kept until it is placed; otherwise it is redrawn at each trial, which favours small ones."}, law.hold_radius);
  v.number({"box_area", "Area of the square box over pi large_radius^2."}, law.box_area, "", range::between(20, 1e6));
  v.integer({"trials", "Positions tried around a disk before it is given up."}, law.trials, {1, 10'000});
  v.flag({"maximal", "After the trials every remaining place where a disk of the class fits is filled; the paper stops after the trials."}, law.maximal);
  v.number({"tolerance", "Relative error of the volume ratio at which the search for the gap between large disks ends."}, law.tolerance, "",
           range::between(1e-4, 0.5));
  v.text({"large", "Material of the large disks, a section of [materials]."}, classes.large);
  v.text({"small", "Material of the small disks, another section of [materials]."}, classes.small);
  for (const auto& [key, name] : {std::pair{"large", classes.large}, {"small", classes.small}})
    v.require(materials.empty() || std::ranges::count(materials, name, &Material::name) > 0, {key},
              fmt::format("there is no section [materials.{0}]; add it, or name the material of the {1} disks with bidisperse.{1}", name, key));
  v.require(classes.large != classes.small, {"small", "large"},
            fmt::format("both classes are made of \"{}\"; give each its own material, with the same numbers if they are alike", classes.small));
  v.require(law.deviation * law.cut < 0.95, {"truncation", "deviation"},
            "radii would be truncated at less than 5 % of their mean; lower truncation or deviation");
}

void declare(Visitor& v, cement::CementParameters& law) {
  using Kind = cement::CementParameters::Kind;
  v.choice({"kind", "Where the matrix is placed."}, law.kind, words(law.kind));
  v.number({"gap",
            "Widest surface gap that is bridged, and at which two grains count as neighbours; unless given, 0.075 of the "
            "mean large radius."},
           law.gap, "mm", range::not_negative);
  const bool is_free = law.kind == Kind::bridges || law.kind == Kind::coating || law.kind == Kind::menisci;
  v.when(is_free, "kind = \"bridges\", \"coating\" or \"menisci\"", [&](Visitor& inner) {
    inner.number({"saturation", "S_m, the fraction of the space between grains filled by matrix: width, thickness or volume is then found."}, law.saturation,
                 "", range::above(0, 1));
  });
  const bool given = !law.saturation;
  v.when(law.kind == Kind::bridges, "kind = \"bridges\"", [&](Visitor& inner) {
    inner.flag({"full_width", "width is the full base of a neck over the radius, not half of it."}, law.full_width);
  });
  v.when(law.kind == Kind::bridges && given, "kind = \"bridges\" without saturation", [&](Visitor& inner) {
    inner.number({"width", "eta: half base of a neck over the radius of its grain."}, law.width, "", range::above(0, 2));
  });
  v.when(law.kind == Kind::coating && given, "kind = \"coating\" without saturation", [&](Visitor& inner) {
    inner.number({"thickness", "Thickness of the layer.", true}, law.thickness, "mm", range::positive);
  });
  v.when(law.kind == Kind::menisci && given, "kind = \"menisci\" without saturation", [&](Visitor& inner) {
    inner.number({"volume", "Volume of one meniscus per unit length.", true}, law.volume, "mm^2", range::positive);
  });
}

void declare(Visitor& v, GridSection& grid) {
  v.integer({"nodes", "Nodes along a side of the square."}, grid.nodes, {7, 32'768});
  v.number({"crop",
            "Side of the centred square to crop; unless given, 25.6 mean large radii of a sampled packing, otherwise "
            "the largest square inside the sample."},
           grid.crop, "mm", range::positive);
  v.flag({"eight_connected", "Pores and voids are also connected across corners."}, grid.cavities.eight_connected);
  v.integer({"fewest_nodes", "Pores and voids of fewer nodes are artefacts of the grid and left out."}, grid.cavities.fewest_nodes, {1, 1'000'000});
  v.flag({"leave_out_border", "Pores and voids that touch the edge are cut, and left out."}, grid.cavities.leave_out_border);
}

void declare(Visitor& v, StiffnessSection& stiffness) {
  v.number({"matrix", "Young's modulus of bonds between two nodes of matrix."}, stiffness.matrix, "GPa", range::positive);
  v.number({"interface", "Young's modulus of bonds between two grains, or grain and matrix; unless given, the matrix's."}, stiffness.interface, "GPa",
           range::positive);
  v.number({"particle", "Young's modulus of bonds inside a grain; unless given, four times the matrix's."}, stiffness.particle, "GPa", range::positive);
  v.flag({"calibrated", "The modulus of the lattice along its axes has the prescribed value; false: the continuum formula, 6 % stiffer."},
         stiffness.calibrated);
}

void declare(Visitor& v, ToughnessSection& toughness) {
  v.number({"matrix", "Fracture toughness of the matrix; it sets the scale of the load."}, toughness.matrix, "MPa m^0.5", range::positive);
  v.number({"interface", "Fracture toughness of the interfaces; unless given, the matrix's."}, toughness.interface, "MPa m^0.5", range::positive);
  v.number({"particle", "Fracture toughness of the grains; unless given, 3.5 times the matrix's."}, toughness.particle, "MPa m^0.5", range::positive);
}

void declare(Visitor& v, stress::StressOptions& statistics) {
  v.integer({"clamp_rows", "Rows of nodes left out at the lower and the upper edge."}, statistics.clamp_rows, {0, 10'000});
  v.flag({"leave_out_surface", "Leave out nodes with a neighbour of another phase or grain."}, statistics.leave_out_surface);
  v.flag({"leave_out_unloaded", "Leave out nodes without any stress: parts not connected to both edges."}, statistics.leave_out_unloaded);
  v.flag({"mean_over_area", "The sample's mean counts the void as zero stress; otherwise it is that of particles and matrix."}, statistics.mean_over_area);
}

void require_own_name(Visitor& v, const Load& load, const Recipe& recipe) {
  v.require(is_plain_name(load.name), {"name"}, "must be made of letters, digits, _ and -");
  const auto same = std::ranges::count(recipe.loads, load.name, &Load::name) + std::ranges::count(recipe.stages, load.name, &Stage::name);
  v.require(same <= 1, {"name"}, fmt::format("another stage or load is called \"{}\"; names must differ", load.name));
}

}  // namespace

peridynamics::Stiffness StiffnessSection::resolved() const { return {matrix, interface.value_or(matrix), particle.value_or(4 * matrix), calibrated}; }

peridynamics::Toughness ToughnessSection::resolved() const { return {matrix, interface.value_or(matrix), particle.value_or(3.5 * matrix)}; }

void declare_bidisperse(Visitor& v, Recipe& recipe) {
  const bool sampled = recipe.packing.method == PackingParameters::Method::poisson;
  v.when(sampled, "packing.method = \"poisson\"", [&](Visitor& outer) {
    outer.optional_section<BidisperseSection>({"bidisperse", "Two size classes of disks in a square box of their own.", sampled}, recipe.bidisperse,
                                              [&](Visitor& inner, BidisperseSection& classes) { declare(inner, classes, recipe.materials); });
  });
}

void declare_field(Visitor& v, Recipe& recipe) {
  v.optional_section<cement::CementParameters>({"cement", "Binding matrix between the grains, added after the last stage."}, recipe.cement,
                                               [](Visitor& inner, cement::CementParameters& law) { declare(inner, law); });
  v.optional_section<GridSection>({"grid", "Square grid of nodes that discretises the cemented packing.", false, "raster"}, recipe.grid,
                                  [](Visitor& inner, GridSection& grid) { declare(inner, grid); });
  v.list<Load>({"loads", "Loads on the cemented sample by peridynamics, each from the unloaded state."}, recipe.loads,
               [&](Visitor& inner, Load& load) { declare(inner, load, recipe); });
}

void declare(Visitor& v, Load& load, const Recipe& recipe) {
  using peridynamics::Loading;
  v.text({"name", "Name of the load, used for its file: letters, digits, _ and -.", true}, load.name);
  require_own_name(v, load, recipe);
  v.choice({"loading", "Direction in which the top row is moved relative to the bottom row."}, load.loading, words(load.loading));
  v.choice({"axis", "Axis from the bottom row to the top row; x loads the rotated sample."}, load.axis, words(load.axis));
  v.choice({"lower", "Support of the bottom row."}, load.lower, words(load.lower));
  v.require(load.loading != Loading::shear || load.lower == peridynamics::LowerEdge::fixed, {"lower", "loading"},
            "a sliding lower edge carries no shear; fix it, or choose tension or compression");
  v.member({"bond_law", "Law of the bonds between nodes."}, load.bond_law);
  v.flag({"failure",
          "Load to failure: bonds break at the critical stretch of their type, load by load. In compression a sample splits and keeps carrying load; "
          "max_strain ends the test."},
         load.failure);
  v.when(!load.failure, "failure = false", [&](Visitor& inner) {
    inner.number({"strain", "Nominal strain: displacement of the top row over the height."}, load.strain, "", range::above(0, 0.5));
    inner.choice({"method", "Solution method for the equilibrium field."}, load.method, words(load.method));
    inner.flag({"exact_stretch", "Exact stretch of the rotated bond, as printed in the paper; otherwise linearised."}, load.exact_stretch);
    inner.flag({"moduli", "Also load along both axes and in shear, for moduli and Poisson's ratios of the sample."}, load.moduli);
    inner.integer({"max_iterations", "Iterations after which a solve gives up; 0: 50, or a million steps of dynamics."}, load.max_iterations,
                  {0, 1'000'000'000});
  });
  v.number({"tolerance", "Residual, relative to that of uniform strain, at which equilibrium is reached."}, load.tolerance, "", range::between(1e-12, 0.1));
  v.when(load.failure, "failure = true", [&](Visitor& inner) {
    inner.number({"max_strain", "Strain at which the test ends."}, load.max_strain, "", range::above(0, 1));
    inner.number({"end_stress", "The test also ends when the stress has fallen to this fraction of its maximum."}, load.end_stress, "", range::above(0, 1));
    inner.number({"band", "Bonds within this fraction of the one furthest beyond its critical stretch break in one round: larger is faster and coarser."},
                 load.band, "", range::between(0, 1));
    inner.section({"toughness", "Fracture toughness, which sets the critical stretch of the bonds."},
                  [&](Visitor& section) { declare(section, load.toughness); });
  });
  v.section({"stiffness", "Young's moduli of the bonds by type."}, [&](Visitor& inner) { declare(inner, load.stiffness); });
  v.section({"statistics", "Nodes that the statistics leave out."}, [&](Visitor& inner) { declare(inner, load.statistics); });
}

}  // namespace arenite::recipe
