#include "workflow/field_stages.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/elasticity/bounds.hpp"
#include "recipe/recipe.hpp"
#include "solid/grid/cavities.hpp"
#include "statistics/numbers.hpp"

namespace arenite::workflow {
namespace {

Numbers estimate(const statistics::Estimate& e) {
  Numbers j{{"value", e.value}};
  if (std::isfinite(e.error)) j["error"] = e.error;
  return j;
}

const char* const parameter_names[] = {"", "width", "", "thickness_m", "volume_m2"};

/// Volumes of pores or voids over pi radius^2 with their density, and what the rules left out.
Numbers volumes(const PhaseMap& map, grid::Cavity kind, const grid::CavityRules& rules, double radius) {
  const auto s = grid::cavity_statistics(find_cavities(map, kind, rules), map.dx, radius);
  Numbers j{{"count", s.count}};
  if (s.count > 0) j["mean"] = estimate({s.mean, s.mean_error});
  if (s.count > 1) {
    j["deviation"] = estimate({s.deviation, s.deviation_error});
    j["cv"] = estimate({s.cv, s.cv_error});
    if (s.peak > 0) j["peak"] = s.peak;
    j["tenth"] = s.tenth;
    j["median"] = s.median;
    j["pdf"] = {{"edge", s.density.edge}, {"density", s.density.density}, {"error", s.density.error}};
  }
  j["specks"] = s.specks;
  j["at_border"] = s.cut;
  return j;
}

bool has_classes(const PhaseMap& map) {
  return std::any_of(map.grain_class.begin(), map.grain_class.end(), [](GrainClass c) { return c != GrainClass::none; });
}

Numbers phases(const PhaseMap& map) {
  const auto f = grid::phase_fractions(map);
  Numbers j{{"particle", f.particle}, {"matrix", f.matrix}, {"void", f.empty}};
  if (has_classes(map)) j.update({{"large", f.large}, {"small", f.small}});
  return j;
}

Numbers grains(const PhaseMap& map) {
  const auto of = [&](GrainClass one) { return static_cast<std::size_t>(std::count(map.grain_class.begin(), map.grain_class.end(), one)); };
  Numbers j{{"all", map.grain_class.size()}};
  if (has_classes(map)) j.update({{"large", of(GrainClass::large)}, {"small", of(GrainClass::small)}});
  return j;
}

Numbers coordination(const texture::GapCoordination& z, double gap) {
  return {{"gap_m", gap},         {"large_grains", z.large}, {"small_grains", z.small}, {"Z", estimate(z.mean)},  {"Z_l", estimate(z.l)},
          {"Z_s", estimate(z.s)}, {"Z_ll", estimate(z.ll)},  {"Z_ls", estimate(z.ls)},  {"Z_sl", estimate(z.sl)}, {"Z_ss", estimate(z.ss)}};
}

Numbers support(const peridynamics::Support& s) {
  return {{"solid", s.solid},           {"carrying", s.carrying}, {"held_below", s.held_below},
          {"held_above", s.held_above}, {"floating", s.floating}, {"islands", s.islands}};
}

Numbers as_asked(const recipe::Load& load) {
  const peridynamics::Stiffness e = load.stiffness.resolved();
  return {{"loading", recipe::word_of(load.loading)},
          {"axis", recipe::word_of(load.axis)},
          {"stiffness_Pa", {{"matrix", e.matrix}, {"interface", e.interface}, {"particle", e.particle}}}};
}

/// Of Young's modulus, by the phases' shares. The lattice's Poisson's ratio is 1/3.
Numbers bounds(const Numbers& phases, const peridynamics::Stiffness& e) {
  const auto b = elasticity::modulus_bounds(
      {{phases["particle"].get<double>(), e.particle}, {phases["matrix"].get<double>(), e.matrix}, {phases["void"].get<double>(), 0}}, 1.0 / 3);
  return {{"voigt", b.voigt}, {"hashin_shtrikman_upper", b.shtrikman_upper}, {"hashin_shtrikman_lower", b.shtrikman_lower}, {"reuss", b.reuss}};
}

// In the order of peridynamics::Ending.
constexpr const char* endings[] = {"solved", "not_converged", "stopped", "severed", "empty"};

}  // namespace

Numbers map_numbers(const PhaseMap& map, const grid::CavityRules& rules, double reference_radius) {
  Numbers j;
  j["map"] = {{"width", map.width}, {"height", map.height}, {"dx_m", map.dx}};
  j["grains"] = grains(map);
  j["phases"] = phases(map);
  const auto fractions = grid::phase_fractions(map);
  j["solid_fraction"] = fractions.particle;
  j["S_m"] = fractions.saturation;
  if (fractions.small > 0) j["volume_ratio"] = fractions.large / fractions.small;
  const auto through = grid::find_percolation(map, rules.eight_connected);
  j["percolates"] = {{"solid_bottom_top", through.solid_bottom_top},
                     {"solid_left_right", through.solid_left_right},
                     {"void_bottom_top", through.void_bottom_top},
                     {"void_left_right", through.void_left_right}};
  j["cavity_rules"] = {{"neighbours", rules.eight_connected ? 8 : 4},
                       {"fewest_nodes", rules.fewest_nodes},
                       {"leave_out_border", rules.leave_out_border},
                       {"reference_radius_m", reference_radius}};
  j["pores"] = volumes(map, grid::Cavity::pore, rules, reference_radius);
  j["voids"] = volumes(map, grid::Cavity::void_, rules, reference_radius);
  return j;
}

void add_reports(Numbers& j, const SampleReports& reports) {
  const auto& c = reports.cement;
  const auto& r = reports.grid;
  const auto kind = static_cast<std::size_t>(reports.law.kind);
  j["area_error"] = {{"particle", r.particle_area_error}, {"matrix", r.matrix_area_error}};
  j["exact"] = {{"solid_fraction", c.areas.particle / c.areas.window}, {"S_m", c.saturation}};
  Numbers cement{{"kind", recipe::word_of(reports.law.kind)}, {"gap_m", *reports.law.gap}, {"necks", c.necks}};
  if (parameter_names[kind][0] != '\0') cement[parameter_names[kind]] = c.parameter;
  if (reports.law.saturation) cement["saturation_error"] = c.saturation_error;
  if (reports.law.kind == cement::CementParameters::Kind::menisci) cement.update({{"ruptured", c.ruptured}, {"capped", c.capped}});
  j["cement"] = cement;
  j["grid"] = {{"corner_m", {r.window.x_min, r.window.y_min}},
               {"side_m", r.window.width()},
               {"necks", r.necks},
               {"lost_necks", r.lost_necks},
               {"lost_area_m2", r.lost_area},
               {"thinnest_neck_nodes", r.thinnest_neck},
               {"smallest_grain_nodes", r.smallest_grain}};
  if (reports.coordination) j["coordination"] = coordination(*reports.coordination, *reports.law.gap);
}

void add_load(Numbers& j, const recipe::Load& load, const peridynamics::LoadReport& report, const std::optional<peridynamics::EffectiveModuli>& moduli) {
  Numbers l = as_asked(load);
  l.update({{"strain", load.strain},
            {"method", recipe::word_of(load.method)},
            {"ending", endings[static_cast<int>(report.ending)]},
            {"iterations", report.iterations},
            {"residual", report.residual},
            {"reaction_balance_error", report.identity_defect},
            {"top_force_N_per_m", {report.top_force.x, report.top_force.y}},
            {"nodes", support(report.support)},
            {"loose_nodes", report.loose_nodes},
            {"hinges", report.hinges.size()}});
  j["load"] = l;
  if (report.ending == peridynamics::Ending::solved) {
    j["modulus_Pa"] = report.modulus;
    if (load.loading != peridynamics::Loading::shear) j["poisson"] = report.poisson;
    if (j.contains("phases")) j["modulus_bounds_Pa"] = bounds(j["phases"], load.stiffness.resolved());
  }
  if (moduli)
    j["moduli"] = {
        {"E_x_Pa", moduli->young_x}, {"E_y_Pa", moduli->young_y}, {"nu_xy", moduli->poisson_xy}, {"nu_yx", moduli->poisson_yx}, {"G_Pa", moduli->shear}};
}

void add_failure(Numbers& j, const recipe::Load& load, const peridynamics::DamageResult& result) {
  Numbers l = as_asked(load);
  const peridynamics::Toughness k = load.toughness.resolved();
  l["toughness_Pa_m0.5"] = {{"matrix", k.matrix}, {"interface", k.interface}, {"particle", k.particle}};
  l.update(
      {{"ending", peridynamics::damage_endings[static_cast<std::size_t>(result.ending)].word}, {"solves", result.solves}, {"iterations", result.iterations}});
  j["load"] = l;
  j["modulus_Pa"] = result.modulus;
  j["strength_Pa"] = result.strength;
  std::array<std::size_t, 4> by_type{};
  for (const auto& bond : result.broken) ++by_type[bond.type & 3u];
  Numbers failure{{"broken", {{"matrix", by_type[1]}, {"interface", by_type[2]}, {"particle", by_type[3]}}}, {"energy_balance_error", result.energy_defect}};
  for (const auto& state : result.curve)
    if (state.stress == result.strength) failure["strain_at_strength"] = state.strain;
  if (!result.curve.empty()) {
    const auto& last = result.curve.back();
    failure.update({{"work_J_per_m", last.work}, {"released_J_per_m", last.released}, {"bond_energy_J_per_m", last.bond_energy}});
  }
  j["failure"] = failure;
}

void add_agreement(Numbers& j, const stress::GrainComparison& comparison) {
  const auto add = [&](const char* component, const stress::ByName<stress::Agreement>& sets) {
    for (const auto& [name, a] : sets) {
      Numbers& one = j["grain_stress_against_contacts"][component][name];
      one = {{"grains", a.grains}, {"correlation", estimate(a.correlation)}, {"slope", estimate(a.slope)}};
      if (std::isfinite(a.rms)) one["rms"] = a.rms;
    }
  };
  add("sigma_yy", comparison.yy);
  add("sigma_hyd", comparison.hydrostatic);
}

}  // namespace arenite::workflow
