#include "study/field_numbers.hpp"

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>

namespace arenite::study {
namespace {

using Json = nlohmann::ordered_json;

Json number(double value) { return std::isfinite(value) ? Json(value) : Json(); }

Json estimate(const statistics::Estimate& e) {
  Json j{{"value", number(e.value)}};
  if (std::isfinite(e.error)) j["error"] = e.error;
  return j;
}

const char* const kinds[] = {"none", "bridges", "full", "coating", "menisci"};
const char* const parameter_names[] = {"", "width", "", "thickness_m", "volume_m2"};
const char* const loadings[] = {"tension", "compression", "shear"};
const char* const methods[] = {"static_solve", "relaxation", "damped"};

/// Sizes of pores or voids: mean with its error over them, scatter, and what the rules left out.
Json sizes(const raster::Cavities& cavities, double node_area, double unit_area) {
  const double per_node = node_area / (unit_area > 0 ? unit_area : 1);
  double sum = 0, squares = 0;
  for (const auto n : cavities.nodes) sum += static_cast<double>(n);
  const auto count = static_cast<double>(cavities.nodes.size());
  const double mean = sum / count;
  for (const auto n : cavities.nodes) squares += (static_cast<double>(n) - mean) * (static_cast<double>(n) - mean);
  const double deviation = std::sqrt(squares / (count - 1));
  Json j{{"count", cavities.nodes.size()}};
  const std::string suffix = unit_area > 0 ? "" : "_m2";
  if (count > 0) j["mean" + suffix] = estimate({mean * per_node, deviation * per_node / std::sqrt(count)});
  if (count > 1) {
    j["deviation" + suffix] = deviation * per_node;
    j["cv"] = deviation / mean;
  }
  j["specks"] = cavities.specks;
  j["at_border"] = cavities.cut;
  return j;
}

Json phases(const PhaseMap& map) {
  std::array<std::size_t, 3> count{}, by_class{};
  for (std::size_t i = 0; i < map.size(); ++i) {
    ++count[static_cast<std::size_t>(map.phase[i])];
    if (map.grain[i] >= 0) ++by_class[static_cast<std::size_t>(map.grain_class[static_cast<std::size_t>(map.grain[i])])];
  }
  const auto share = [&](std::size_t n) { return static_cast<double>(n) / static_cast<double>(map.size()); };
  Json j{{"particle", share(count[2])}, {"matrix", share(count[1])}, {"void", share(count[0])}};
  if (by_class[0] < count[2]) {
    j["large"] = share(by_class[static_cast<std::size_t>(GrainClass::large)]);
    j["small"] = share(by_class[static_cast<std::size_t>(GrainClass::small)]);
  }
  return j;
}

Json grains(const PhaseMap& map) {
  std::array<std::size_t, 3> count{};
  for (const GrainClass each : map.grain_class) ++count[static_cast<std::size_t>(each)];
  Json j{{"all", map.grain_class.size()}};
  if (count[0] < map.grain_class.size()) {
    j["large"] = count[static_cast<std::size_t>(GrainClass::large)];
    j["small"] = count[static_cast<std::size_t>(GrainClass::small)];
  }
  return j;
}

Json coordination(const texture::GapCoordination& z, double gap) {
  return {{"gap_m", gap},        {"large_grains", z.large}, {"small_grains", z.small}, {"Z", estimate(z.mean)},  {"Z_l", estimate(z.l)},
          {"Z_s", estimate(z.s)}, {"Z_ll", estimate(z.ll)},  {"Z_ls", estimate(z.ls)},  {"Z_sl", estimate(z.sl)}, {"Z_ss", estimate(z.ss)}};
}

Json support(const peridynamics::Support& s) {
  return {{"solid", s.solid}, {"carrying", s.carrying}, {"held_below", s.held_below}, {"held_above", s.held_above},
          {"floating", s.floating}, {"islands", s.islands}};
}

Json as_asked(const Load& load) {
  const peridynamics::Stiffness e = load.stiffness.resolved();
  return {{"loading", loadings[static_cast<std::size_t>(load.loading)]},
          {"axis", load.axis == Load::Axis::y ? "y" : "x"},
          {"stiffness_Pa", {{"matrix", e.matrix}, {"interface", e.interface}, {"particle", e.particle}}}};
}

const char* word(peridynamics::Ending ending) {
  using peridynamics::Ending;
  switch (ending) {
    case Ending::solved: return "solved";
    case Ending::not_converged: return "not_converged";
    case Ending::stopped: return "stopped";
    case Ending::severed: return "severed";
    case Ending::empty: return "empty";
  }
  return "";
}

const char* word(peridynamics::DamageResult::Ending ending) {
  using Ending = peridynamics::DamageResult::Ending;
  switch (ending) {
    case Ending::severed: return "severed";
    case Ending::dropped: return "dropped";
    case Ending::strain_reached: return "strain_reached";
    case Ending::events_reached: return "events_reached";
    case Ending::not_converged: return "not_converged";
    case Ending::stopped: return "stopped";
    case Ending::no_path: return "no_path";
  }
  return "";
}

}  // namespace

std::string map_numbers(const PhaseMap& map, const raster::CavityRules& rules, double reference_radius) {
  Json j;
  j["map"] = {{"width", map.width}, {"height", map.height}, {"dx_m", map.dx}};
  j["grains"] = grains(map);
  j["phases"] = phases(map);
  const double particle = j["phases"]["particle"], matrix = j["phases"]["matrix"];
  j["solid_fraction"] = particle;
  if (particle < 1) j["S_m"] = matrix / (1 - particle);
  const double unit = M_PI * reference_radius * reference_radius, node = map.dx * map.dx;
  j["cavity_rules"] = {{"neighbours", rules.eight_connected ? 8 : 4}, {"fewest_nodes", rules.fewest_nodes},
                       {"leave_out_border", rules.leave_out_border}};
  if (reference_radius > 0) j["cavity_rules"]["volumes_over_m2"] = unit;
  j["pores"] = sizes(find_cavities(map, raster::Cavity::pore, rules), node, unit);
  j["voids"] = sizes(find_cavities(map, raster::Cavity::void_, rules), node, unit);
  return j.dump();
}

std::string with_reports(const std::string& numbers, const SampleReports& reports) {
  Json j = Json::parse(numbers);
  const auto& c = reports.cement;
  const auto& r = reports.raster;
  const auto kind = static_cast<std::size_t>(reports.section.law.kind);
  j["area_error"] = {{"particle", r.particle_area_error}, {"matrix", r.matrix_area_error}};
  j["exact"] = {{"solid_fraction", c.areas.particle / c.areas.window}, {"S_m", c.saturation}};
  Json cement{{"kind", kinds[kind]}, {"gap_m", reports.gap}, {"joints", c.joints}};
  if (parameter_names[kind][0] != '\0') cement[parameter_names[kind]] = c.parameter;
  if (reports.section.law.saturation) cement["saturation_error"] = c.saturation_error;
  if (reports.section.law.kind == cement::CementParameters::Kind::menisci) {
    cement["ruptured"] = c.ruptured;
    cement["capped"] = c.capped;
  }
  j["cement"] = cement;
  j["raster"] = {{"corner_m", {r.window.x_min, r.window.y_min}}, {"side_m", r.window.width()}, {"joints", r.joints},
                 {"lost_joints", r.lost_joints}, {"lost_area_m2", r.lost_area}, {"thinnest_joint_nodes", r.thinnest_joint},
                 {"smallest_grain_nodes", r.smallest_grain}};
  if (reports.coordination) j["coordination"] = coordination(*reports.coordination, reports.gap);
  return j.dump();
}

std::string with_load(const std::string& numbers, const Load& load, const peridynamics::LoadReport& report,
                      const std::optional<peridynamics::EffectiveModuli>& moduli) {
  Json j = Json::parse(numbers);
  Json l = as_asked(load);
  l["strain"] = load.strain;
  l["method"] = methods[static_cast<std::size_t>(load.method)];
  l["ending"] = word(report.ending);
  l["iterations"] = report.iterations;
  l["residual"] = report.residual;
  l["identity_defect"] = report.identity_defect;
  l["top_force_N_per_m"] = {report.top_force.x, report.top_force.y};
  l["nodes"] = support(report.support);
  l["loose_nodes"] = report.loose_nodes;
  l["hinges"] = report.hinges.size();
  j["load"] = l;
  if (report.ending == peridynamics::Ending::solved) {
    j["modulus_Pa"] = report.modulus;
    if (load.loading != peridynamics::Loading::shear) j["poisson"] = report.poisson;
  }
  if (moduli)
    j["moduli"] = {{"E_x_Pa", moduli->young_x}, {"E_y_Pa", moduli->young_y}, {"nu_xy", moduli->poisson_xy},
                   {"nu_yx", moduli->poisson_yx}, {"G_Pa", moduli->shear}};
  return j.dump();
}

std::string with_failure(const std::string& numbers, const Load& load, const peridynamics::DamageResult& result) {
  Json j = Json::parse(numbers);
  Json l = as_asked(load);
  const peridynamics::Toughness k = load.toughness.resolved();
  l["toughness_Pa_m0.5"] = {{"matrix", k.matrix}, {"interface", k.interface}, {"particle", k.particle}};
  l["ending"] = word(result.ending);
  l["solves"] = result.solves;
  l["iterations"] = result.iterations;
  j["load"] = l;
  j["modulus_Pa"] = result.modulus;
  j["strength_Pa"] = result.strength;
  std::array<std::size_t, 4> by_type{};
  for (const auto& bond : result.broken) ++by_type[bond.type & 3u];
  Json failure{{"broken", {{"matrix", by_type[1]}, {"interface", by_type[2]}, {"particle", by_type[3]}}}, {"energy_defect", result.energy_defect}};
  for (const auto& state : result.curve)
    if (state.stress == result.strength) failure["strain_at_strength"] = state.strain;
  if (!result.curve.empty()) {
    const auto& last = result.curve.back();
    failure["work_J_per_m"] = last.work;
    failure["released_J_per_m"] = last.released;
    failure["bond_energy_J_per_m"] = last.bond_energy;
  }
  j["failure"] = failure;
  return j.dump();
}

std::string with_stress(const std::string& numbers, const std::string& stress_json) {
  Json j = Json::parse(numbers);
  j["stress"] = Json::parse(stress_json);
  return j.dump();
}

std::string with_note(const std::string& numbers, const std::string& note) {
  Json j = Json::parse(numbers);
  j["notes"].push_back(note);
  return j.dump();
}

}  // namespace arenite::study
