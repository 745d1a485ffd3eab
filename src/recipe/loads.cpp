#include "recipe/loads.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/text.hpp"
#include "model/packing.hpp"
#include "recipe/recipe.hpp"
#include "solid/peridynamics/lattice.hpp"
#include "solid/statics/loading.hpp"

namespace arenite::recipe {

using Visitor = ParameterVisitor;

std::vector<Word> words(peridynamics::Loading) {
  return {{"tension", "away from it"}, {"compression", "towards it"}, {"shear", "along it, to the right"}};
}

std::vector<Word> words(peridynamics::LowerEdge) {
  return {{"fixed", "nothing moves"}, {"sliding", "free along the row"}};
}

std::vector<Word> words(LoadMethod) {
  return {
      {"peridynamics",
       "bonds between nodes, as in the paper, whose Poisson's ratio is 1/3 (in space 1/4); conjugate gradients with a "
       "coarse space divided by grain: seconds",
       "static_solve"},
      {"elements",
       "finite elements, one a pixel, with any Poisson's ratio, by the same solver; necks of few nodes are as stiff as "
       "they are"},
      {"relaxation", "bonds, by adaptive dynamic relaxation: half a minute"},
      {"damped", "bonds, by dynamics with a fixed viscosity, as in the paper: minutes"}};
}

std::vector<Word> words(elements::Element) {
  return {{"wilson", "with incompatible modes: exact in bending"}, {"full", "bilinear, fully integrated"}};
}

std::vector<Word> words(elements::PlaneState) {
  return {{"stress", "nothing pulls across the plane: a thin plate"},
          {"strain", "nothing strains across the plane: a long prism"}};
}

std::vector<Word> words(Load::Axis) { return {{"y", ""}, {"x", ""}}; }

namespace {

void declare(Visitor& v, StiffnessSection& stiffness) {
  v.number({"matrix", "Young's modulus of the matrix: of bonds between two of its nodes, or its elements."},
           stiffness.matrix, "GPa", range::positive);
  v.number(
      {"interface",
       "Young's modulus of bonds between two grains, or grain and matrix; of elements of a grain that touch another "
       "grain, and of the matrix that touch one; unless given, the matrix's."},
      stiffness.interface, "GPa", range::positive);
  static const std::string particle = fmt::format("Young's modulus of the grains; unless given, {} times the matrix's.",
                                                  peridynamics::particle_modulus_over_matrix);
  v.number({"particle", particle}, stiffness.particle, "GPa", range::positive);
  v.flag({"calibrated",
          "The modulus of the lattice along its axes has the prescribed value; false: the continuum formula, 6 % "
          "stiffer."},
         stiffness.calibrated);
}

void declare(Visitor& v, PoissonSection& poisson) {
  constexpr Range allowed{-0.99, 0.499};
  v.number({"matrix", "Poisson's ratio of the matrix."}, poisson.matrix, "", allowed);
  v.number({"interface", "Poisson's ratio of the interfaces; unless given, the matrix's."}, poisson.interface, "",
           allowed);
  v.number({"particle", "Poisson's ratio of the grains; unless given, the matrix's."}, poisson.particle, "", allowed);
}

void declare(Visitor& v, ToughnessSection& toughness) {
  v.number({"matrix", "Fracture toughness of the matrix; it sets the scale of the load."}, toughness.matrix,
           "MPa m^0.5", range::positive);
  v.number({"interface", "Fracture toughness of the interfaces; unless given, the matrix's."}, toughness.interface,
           "MPa m^0.5", range::positive);
  static const std::string particle = fmt::format(
      "Fracture toughness of the grains; unless given, {} times the matrix's.", peridynamics::particle_over_matrix);
  v.number({"particle", particle}, toughness.particle, "MPa m^0.5", range::positive);
}

void declare(Visitor& v, StrengthSection& strength) {
  v.number({"matrix", "Tensile strength of the matrix; unless given, toughness alone breaks its bonds."},
           strength.matrix, "MPa", range::positive);
  v.number({"interface", "Tensile strength of the interfaces; unless given, the matrix's."}, strength.interface, "MPa",
           range::positive);
  static const std::string particle = fmt::format(
      "Tensile strength of the grains; unless given, {} times the matrix's.", peridynamics::particle_over_matrix);
  v.number({"particle", particle}, strength.particle, "MPa", range::positive);
}

void declare(Visitor& v, stress::StressOptions& statistics) {
  v.integer({"clamp_rows", "Rows of nodes left out at the lower and the upper edge."}, statistics.clamp_rows,
            {0, 10'000});
  v.flag({"leave_out_surface", "Leave out nodes with a neighbour of another phase or grain."},
         statistics.leave_out_surface);
  v.flag({"leave_out_unloaded", "Leave out nodes without any stress: parts not connected to both edges."},
         statistics.leave_out_unloaded);
  v.flag({"mean_over_area",
          "The sample's mean counts the void as zero stress; otherwise it is that of particles and matrix."},
         statistics.mean_over_area);
}

void require_own_name(Visitor& v, const Load& load, const Recipe& recipe) {
  v.require(is_plain_name(load.name), {"name"}, "must be made of letters, digits, _ and -");
  const auto same = std::ranges::count(recipe.loads, load.name, &Load::name) +
                    std::ranges::count(recipe.stages, load.name, &Stage::name);
  v.require(same <= 1, {"name"}, fmt::format("another stage or load is called \"{}\"; names must differ", load.name));
}

/// A load at one strain.
void declare_strained_once(Visitor& inner, Load& load) {
  inner.number({"strain", "Nominal strain: displacement of the top row over the height."}, load.strain, "",
               range::above(0, 0.5));
  inner.choice({"method", "What joins the nodes, and how the field at equilibrium is found."}, load.method,
               words(load.method));
  inner.when(load.method == LoadMethod::elements, "method = \"elements\"", [&](Visitor& elements) {
    elements.choice({"element", "How an element bends."}, load.element, words(load.element));
    elements.choice({"plane", "What happens across the plane."}, load.plane, words(load.plane));
    elements.section({"poisson", "Poisson's ratios of elements by phase."},
                     [&](Visitor& section) { declare(section, load.poisson); });
    elements.flag({"effective_stiffness",
                   "Also find the effective stiffness of the sample repeated in all directions, which needs no "
                   "clamps: three uniform strains in the plane, six in space."},
                  load.effective_stiffness);
  });
  inner.flag({"exact_stretch", "Exact stretch of the rotated bond, as printed in the paper; otherwise linearised."},
             load.exact_stretch);
  inner.flag(
      {"moduli",
       "Also load along both axes and in shear, for the apparent moduli and Poisson's ratios between rigid clamps."},
      load.moduli);
  static const std::string most = fmt::format(
      "Iterations after which a solve gives up; 0: {}, in space {}, more for a finer tolerance, or {} steps of "
      "dynamics.",
      statics::usual_cap(Load{}.tolerance), statics::usual_cap(Load{}.tolerance, 3), peridynamics::usual_steps);
  inner.integer({"max_iterations", most}, load.max_iterations, {0, 1'000'000'000});
}

void declare_failure(Visitor& inner, Load& load) {
  inner.number({"max_strain", "Strain at which the test ends."}, load.max_strain, "", range::above(0, 1));
  inner.number({"end_stress", "The test also ends when the stress has fallen to this fraction of its maximum."},
               load.end_stress, "", range::above(0, 1));
  inner.number({"band",
                "Bonds within this fraction of the one furthest beyond its critical stretch break in one round: "
                "larger is faster and coarser."},
               load.band, "", range::between(0, 1));
  inner.flag(
      {"cracks_stay_open", "A broken bond is gone; otherwise faces that have parted push where they meet again."},
      load.cracks_stay_open);
  inner.section({"toughness",
                 "Fracture toughness: bonds break at the critical stretch that it sets, which grows as the node "
                 "spacing to the power -1/2."},
                [&](Visitor& section) { declare(section, load.toughness); });
  inner.section({"strength",
                 "Tensile strength: bonds break at its strain where that is below the critical stretch of the "
                 "toughness, on any grid."},
                [&](Visitor& section) { declare(section, load.strength); });
}

}  // namespace

void declare(Visitor& v, Load& load) {
  using peridynamics::Loading;
  v.choice({"loading", "Direction in which the top row is moved relative to the bottom row."}, load.loading,
           words(load.loading));
  v.choice({"axis", "Axis from the bottom row to the top row; x loads the sample with x and y exchanged."}, load.axis,
           words(load.axis));
  v.choice({"lower", "Support of the bottom row."}, load.lower, words(load.lower));
  v.require(load.loading != Loading::shear || load.lower == peridynamics::LowerEdge::fixed, {"lower", "loading"},
            "a sliding lower edge carries no shear; fix it, or choose tension or compression");
  v.member({"bond_law", "Law of the bonds between nodes."}, load.law);
  static const std::string stops = fmt::format(
      "No bond passes through a void node, so that a crack of one node cuts; otherwise bonds reach across voids "
      "thinner "
      "than the horizon of {} nodes.",
      peridynamics::horizon);
  v.flag({"stop_at_voids", stops}, load.stop_at_voids);
  v.flag({"failure",
          "Load to failure: bonds break at the critical stretch of their type, load by load. In compression a sample "
          "splits and keeps carrying load: max_strain ends the test."},
         load.failure);
  v.when(!load.failure, "failure = false", [&](Visitor& inner) { declare_strained_once(inner, load); });
  v.when(load.method == LoadMethod::peridynamics, "method = \"peridynamics\"", [&](Visitor& bonds) {
    static const std::string in_space = fmt::format(
        "Horizon of the bonds in space, in voxels: 2 for 32 bonds a voxel, 3 for 122, which cost four times as much. "
        "In "
        "the plane it is {} nodes.",
        peridynamics::horizon);
    bonds.integer({"horizon_in_space", in_space}, load.horizon_in_space, {2, 3});
  });
  v.number({"tolerance", "Residual, relative to that of uniform strain, at which equilibrium is reached."},
           load.tolerance, "", range::between(1e-12, 0.1));
  v.when(load.failure, "failure = true", [&](Visitor& inner) { declare_failure(inner, load); });
  v.section({"stiffness", "Young's moduli of bonds or elements by type."},
            [&](Visitor& inner) { declare(inner, load.stiffness); });
  v.section({"statistics", "Nodes that the statistics leave out."},
            [&](Visitor& inner) { declare(inner, load.statistics); });
}

peridynamics::Method Load::bond_method() const {
  return method == LoadMethod::relaxation ? peridynamics::Method::relaxation
         : method == LoadMethod::damped   ? peridynamics::Method::damped
                                          : peridynamics::Method::static_solve;
}

std::vector<std::string> Load::idle_keys() const {
  std::vector<std::string> sentences;
  const auto tell = [&](bool given, std::string_view key) {
    if (given && by_elements())
      sentences.push_back(fmt::format(
          "{}: has no effect, because elements have no bonds; leave it out, or choose another method", key));
  };
  tell(exact_stretch, "exact_stretch");
  tell(stop_at_voids, "stop_at_voids");
  tell(!stiffness.calibrated, "stiffness.calibrated");
  return sentences;
}

std::string Load::not_in_space() const {
  if (!by_elements() && method != LoadMethod::peridynamics)
    return "dynamic solvers are of the plane; in space give method = \"peridynamics\" or \"elements\"";
  if (!by_elements() && (exact_stretch || stop_at_voids || !stiffness.calibrated))
    return "bonds in space have the linearised stretch, pass thin voids and are calibrated; leave exact_stretch, "
           "stop_at_voids and calibrated out in space";
  if (!by_elements() && effective_stiffness)
    return "the effective stiffness is that of elements; give method = \"elements\" with it";
  if (axis == Axis::x) return "in space the load acts along z, across the slices; leave axis out, or turn the image";
  if (moduli)
    return "moduli between clamps along both axes are of the plane; in space give effective_stiffness, which needs "
           "none";
  if (statistics.leave_out_surface || statistics.leave_out_unloaded || statistics.mean_over_area)
    return "statistics in space are of all solid voxels between the clamps' layers; leave leave_out_surface, "
           "leave_out_unloaded and mean_over_area out";
  if (plane != elements::PlaneState::stress) return "plane strain is of the plane; leave plane out in space";
  return {};
}

elements::Material Load::material() const {
  const peridynamics::Stiffness e = stiffness.resolved();
  return {{e.matrix, poisson.matrix},
          {e.interface, poisson.interface.value_or(poisson.matrix)},
          {e.particle, poisson.particle.value_or(poisson.matrix)},
          element,
          plane};
}

peridynamics::Stiffness StiffnessSection::resolved() const {
  return {matrix, interface.value_or(matrix), particle.value_or(peridynamics::particle_modulus_over_matrix * matrix),
          calibrated};
}

peridynamics::Toughness ToughnessSection::resolved() const {
  return {matrix, interface.value_or(matrix), particle.value_or(peridynamics::particle_over_matrix * matrix)};
}

peridynamics::Strength StrengthSection::resolved() const {
  const double of_matrix = matrix.value_or(HUGE_VAL);
  return {of_matrix, interface.value_or(of_matrix), particle.value_or(peridynamics::particle_over_matrix * of_matrix)};
}

namespace {

void declare_cemented(Visitor& v, Recipe& recipe) {
  v.optional_section<cement::CementParameters>(
      {"cement", "Binding matrix between the grains, added after the last stage."}, recipe.cement,
      [&](Visitor& inner, cement::CementParameters& law) { recipe::declare(inner, law, recipe.dimension); });
  v.optional_section<GridSection>(
      {"grid", "Square grid of nodes, in space a cube of voxels, that discretises the cemented packing.", false,
       "raster"},
      recipe.grid, [&](Visitor& inner, GridSection& grid) { declare(inner, grid, recipe.dimension); });
}

}  // namespace

void declare_field(Visitor& v, Recipe& recipe) {
  v.when(!recipe.map, no_map, [&](Visitor& of_grains) { declare_cemented(of_grains, recipe); });
  v.list<Load>(
      {"loads", "Loads on the cemented sample, or on [map], by bonds or elements, each from the unloaded state."},
      recipe.loads, [&](Visitor& inner, Load& load) {
        inner.text({"name", "Name of the load, used for its file: letters, digits, _ and -.", true}, load.name);
        require_own_name(inner, load, recipe);
        declare(inner, load);
      });
}

}  // namespace arenite::recipe
