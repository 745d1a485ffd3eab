#include "workflow/field_numbers.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>

#include "model/elasticity/bounds.hpp"
#include "recipe/recipe.hpp"
#include "solid/grid/thin_voids.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/measures.hpp"
#include "statistics/numbers.hpp"

namespace arenite::workflow {
namespace {

using statistics::described;

/// What a kind of cement is given by, if by anything.
constexpr struct {
  const char *name, *unit, *sentence;
} parameters[] = {{"", "", ""},
                  {"width", "", "Half base of a neck over the radius of its grain"},
                  {"", "", ""},
                  {"thickness_m", "m", "Thickness of the coating"},
                  {"volume_m2", "m^2", "Area of a meniscus"}};

Numbers support(const peridynamics::Support& s) {
  return {{"solid", described(s.solid, "", "Nodes that are not void")},
          {"carrying", described(s.carrying, "", "Of these, nodes connected to both clamps")},
          {"held_below", described(s.held_below, "", "Nodes connected to the lower clamp only, without stress")},
          {"held_above", described(s.held_above, "", "Nodes connected to the upper clamp only, without stress")},
          {"floating", described(s.floating, "", "Nodes connected to neither clamp, without stress")},
          {"islands", described(s.islands, "", "Separate parts of these")}};
}

/// Those that are finite.
Numbers limits(const peridynamics::Strength& f) {
  Numbers j = Numbers::tree();
  const std::array of{f.matrix, f.interface, f.particle};
  for (std::size_t k = 0; k < of.size(); ++k)
    if (std::isfinite(of[k])) j[std::string(crack_types[k + 1])] = of[k];
  return described(std::move(j), "Pa", "Tensile strength of these bonds");
}

/// Of Young's modulus, by the phases' shares; none are told of plane strain and of phases that differ in Poisson's
/// ratio.
std::optional<elasticity::ModulusBounds> bounds(const Numbers& phases, const recipe::Load& load) {
  const elements::Material m = load.material();
  if (load.by_elements() && m.plane != elements::PlaneState::stress) return std::nullopt;
  const auto poisson = [&](const elements::Constants& of) {
    return load.by_elements() ? of.poisson : peridynamics::lattice_poisson;
  };
  const peridynamics::Stiffness e = load.stiffness.resolved();
  return elasticity::modulus_bounds({{phases["particle"].get<double>(), e.particle, poisson(m.particle)},
                                     {phases["matrix"].get<double>(), e.matrix, poisson(m.matrix)},
                                     {phases["void"].get<double>(), 0, poisson(m.matrix)}});
}

// In the order of peridynamics::Ending.
constexpr const char* endings[] = {"solved", "not_converged", "stopped", "severed", "empty"};

}  // namespace

Numbers as_asked(const recipe::Load& load) {
  const peridynamics::Stiffness e = load.stiffness.resolved();
  Numbers j{{"loading", recipe::word_of(load.loading)},
            {"axis", recipe::word_of(load.axis)},
            {"stiffness_Pa", described(by_type(e.matrix, e.interface, e.particle), "Pa",
                                       "Young's modulus of these bonds or elements")}};
  if (!load.by_elements()) return j;
  const elements::Material m = load.material();
  j["element"] = recipe::word_of(m.element);
  j["plane"] = recipe::word_of(m.plane);
  j["poisson_ratio"] = described(by_type(m.matrix.poisson, m.interface.poisson, m.particle.poisson), "",
                                 "Poisson's ratio of these elements");
  return j;
}

void add_reports(Numbers& j, const SampleReports& reports) {
  const auto& c = reports.cement;
  const auto& r = reports.grid;
  const auto kind = static_cast<std::size_t>(reports.law.kind);
  const char* off = "Area of the nodes over the exact area, minus 1";
  j["area_error"] = described({{"particle", r.particle_area_error}, {"matrix", r.matrix_area_error}}, "", off);
  j["exact"] = {
      {"solid_fraction",
       described(c.areas.particle / c.areas.window, "", "Fraction of the area in grains, by exact areas")},
      {"S_m", described(c.saturation, "", "Fraction of the space between grains filled by matrix, by exact areas")}};
  Numbers cement{{"kind", recipe::word_of(reports.law.kind)},
                 {"gap_m", described(*reports.law.gap, "m", "Largest gap bridged by a neck")},
                 {"necks", described(c.necks, "", "Pairs of grains with a neck")}};
  if (const auto& [name, unit, sentence] = parameters[kind]; *name != '\0')
    cement[name] = described(c.parameter, unit, sentence);
  if (reports.law.saturation)
    cement["saturation_error"] = described(c.saturation_error, "", "S_m minus the prescribed value");
  if (reports.law.kind == cement::CementParameters::Kind::menisci)
    cement.update(
        {{"ruptured", described(c.ruptured, "", "Menisci too small to span their gap, left out")},
         {"capped", described(c.capped, "", "Menisci with less than the prescribed volume, with straight arcs")}});
  j["cement"] = cement;
  j["grid"] = {
      {"corner_m", described({r.window.x_min, r.window.y_min}, "m", "Lower left corner of the window in the sample")},
      {"side_m", described(r.window.width(), "m", "Side of the window")},
      {"necks", described(r.necks, "", "Necks in the window")},
      {"lost_necks", described(r.lost_necks, "", "Necks without a node")},
      {"lost_area_m2", described(r.lost_area, "m^2", "Their area")},
      {"thinnest_neck_nodes", described(r.thinnest_neck, "", "Nodes across the thinnest neck")},
      {"smallest_grain_nodes", described(r.smallest_grain, "", "Nodes across the smallest grain")}};
  if (!reports.coordination.empty()) j["coordination"] = reports.coordination;
}

void add_load(Numbers& j, const recipe::Load& load, const peridynamics::LoadReport& report,
              const std::optional<peridynamics::EffectiveModuli>& moduli) {
  Numbers l = as_asked(load);
  l.update({{"strain", described(load.strain, "", "Strain of the sample")},
            {"method", recipe::word_of(load.method)},
            {"ending", endings[static_cast<int>(report.ending)]},
            {"iterations", described(report.iterations, "", "Iterations of the solver")},
            {"residual", described(report.residual, "", "Out-of-balance force over that of uniform strain")},
            {"reaction_balance_error",
             described(report.identity_defect, "",
                       "Volume integral of sigma_yy over the product of clamp force and height, minus 1")},
            {"top_force_N_per_m", described({report.top_force.x, report.top_force.y}, "N/m",
                                            "Force of the upper clamp on the sample, per metre of depth")},
            {"nodes", support(report.support)},
            {"loose_nodes", described(report.loose_nodes, "", "Nodes without stiffness in some direction")},
            {"hinges", described(report.hinges.size(), "", "Nodes about which a part of the sample can rotate")}});
  j["load"] = l;
  if (report.ending == peridynamics::Ending::solved) {
    j["modulus_Pa"] = described(report.modulus, "Pa", "Apparent modulus, mean stress over strain");
    if (load.loading != peridynamics::Loading::shear)
      j["poisson"] = described(report.poisson, "", "Apparent Poisson's ratio, of the middle half");
    if (const auto b = j.contains("phases") ? bounds(j["phases"], load) : std::nullopt)
      j["modulus_bounds_Pa"] = described({{"voigt", b->voigt},
                                          {"hashin_shtrikman_upper", b->shtrikman_upper},
                                          {"hashin_shtrikman_lower", b->shtrikman_lower},
                                          {"reuss", b->reuss}},
                                         "Pa", "Bound of Young's modulus from the phase fractions");
  }
  if (moduli)
    j["apparent_moduli"] = {
        {"E_x_Pa", described(moduli->young_x, "Pa", "Apparent Young's modulus along x, between rigid clamps")},
        {"E_y_Pa", described(moduli->young_y, "Pa", "Apparent Young's modulus along y, between rigid clamps")},
        {"nu_xy",
         described(moduli->poisson_xy, "", "Apparent Poisson's ratio for tension along x, of the middle half")},
        {"nu_yx",
         described(moduli->poisson_yx, "", "Apparent Poisson's ratio for tension along y, of the middle half")},
        {"G_Pa", described(moduli->shear, "Pa", "Apparent shear modulus between rigid clamps, with free sides")}};
}

std::string note_of_bridged_crack(int length, int side, int horizon, const std::string& remedy) {
  constexpr int few = 10;  // nodes: a wedge between grains that touch is as long
  if (length <= std::max(few, side / 10)) return {};
  return fmt::format(
      "bonds reach across a void that is {} nodes long and thinner than {}, as if it were no crack; {} "
      "lets none pass",
      length, horizon, remedy);
}

void note_bonds_across_voids(Numbers& j, const recipe::Load& load, const PhaseMap& upright) {
  if (load.stop_at_voids) return;
  j["load"]["bonds_across_voids"] =
      described(peridynamics::bonds_across_voids(upright), "",
                "Bonds that pass through a void node: they carry load across cracks thinner than 3 nodes");
  const Numbers* carrying = j.at_path("/load/nodes/carrying");
  const bool carries = carrying ? carrying->get<double>() > 0 : j["strength_Pa"].get<double>() > 0;
  if (!carries) return;
  if (peridynamics::joined_through_voids_only(upright))
    j["notes"].push_back(
        "no solid joins the two clamps: all load passes through bonds that reach across voids thinner than 3 nodes; "
        "stop_at_voids (--stop-at-voids) lets no bond pass");
  else if (auto note = note_of_bridged_crack(grid::longest_thin_void(upright, peridynamics::horizon - 1),
                                             std::min(upright.width, upright.height), peridynamics::horizon,
                                             "stop_at_voids (--stop-at-voids)");
           !note.empty())
    j["notes"].push_back(std::move(note));
}

namespace {

/// How numbers of a test are called: energies in the plane are per unit thickness.
struct FailureWords {
  const char *suffix, *unit, *per, *spacing;
};
template <int D> constexpr FailureWords failure_words{"_J_per_m", "J/m", ", per metre of depth", "of node spacing"};
template <> constexpr FailureWords failure_words<3>{"_J", "J", "", "of voxels of"};

/// What breaks the bonds of this grid, and what a strength found on it hangs on.
template <int D> void add_criterion(Numbers& j, const recipe::Load& load, double dx) {
  const auto limits = peridynamics::breaking_limits<D>(
      {load, load, load.stiffness.resolved(), {}, load.toughness.resolved(), load.strength.resolved()}, dx);
  const auto& s = limits.stretch;
  const auto governs = [&](std::size_t type) {
    return limits.set_by[type] == peridynamics::Limit::strength ? "strength" : "toughness";
  };
  j["failure"]["critical_stretch"] =
      described(by_type(s[1], s[2], s[3]), "", "Stretch at which these bonds break on this grid");
  j["failure"]["governed_by"] = by_type(governs(1), governs(2), governs(3));
  j["notes"].push_back(fmt::format(
      "the strength is that of this grid, {} {:.4g} m: {}; compare samples at one spacing "
      "(docs/peridynamics.md)",
      failure_words<D>.spacing, dx,
      limits.follow_spacing()
          ? "bonds break at a stretch that follows from their toughness and grows as the spacing to the power -1/2"
          : "bonds break at the strength given, which is reached the sooner where stress concentrates the finer the "
            "grid"));
}

}  // namespace

template <int D>
void add_failure(Numbers& j, Numbers asked, const recipe::Load& load, const peridynamics::DamageOutcome& result,
                 double dx) {
  const peridynamics::Toughness k = load.toughness.resolved();
  asked["toughness_Pa_m0.5"] =
      described(by_type(k.matrix, k.interface, k.particle), "Pa m^0.5", "Fracture toughness of these bonds");
  if (load.strength.matrix || load.strength.interface || load.strength.particle)
    asked["strength_Pa"] = limits(load.strength.resolved());
  asked["cracks_stay_open"] =
      described(load.cracks_stay_open, "", "Whether faces that have parted do not push where they meet again");
  asked.update({{"ending", peridynamics::damage_endings[static_cast<std::size_t>(result.ending)].word},
                {"solves", described(result.solves, "", "Static solutions")},
                {"iterations", described(result.iterations, "", "Iterations of the solver")}});
  j["load"] = std::move(asked);
  j["modulus_Pa"] = described(result.modulus, "Pa", "Apparent modulus before the first bond breaks");
  j["strength_Pa"] = described(result.strength, "Pa", "Strength, largest mean stress");
  const auto broken = peridynamics::broken_by_type(result.broken);
  Numbers failure{{"broken", described(by_type(broken[1], broken[2], broken[3]), "", "Bonds broken")},
                  {"energy_balance_error",
                   described(result.energy_defect, "", "Largest |work - elastic - released energy| over the work")}};
  if (const auto strain = peridynamics::strain_at_strength(result))
    failure["strain_at_strength"] = described(*strain, "", "Strain at the largest mean stress");
  const auto add_energy = [&](const char* name, double value, const char* meaning) {
    const FailureWords& words = failure_words<D>;
    failure[std::string(name) + words.suffix] =
        described(value, words.unit, (std::string(meaning) + words.per).c_str());
  };
  if (!result.curve.empty()) {
    const auto& last = result.curve.back();
    add_energy("work", last.work, "Work of the load");
    add_energy("released", last.released, "Elastic energy released by breaking bonds");
    failure[std::string("bond_energy") + failure_words<D>.suffix] =
        described(last.bond_energy, failure_words<D>.unit, "Part of it that was stored in the broken bonds");
  }
  j["failure"] = failure;
  add_criterion<D>(j, load, dx);
}
template void add_failure<2>(Numbers&, Numbers, const recipe::Load&, const peridynamics::DamageOutcome&, double);
template void add_failure<3>(Numbers&, Numbers, const recipe::Load&, const peridynamics::DamageOutcome&, double);

}  // namespace arenite::workflow
