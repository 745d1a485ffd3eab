#include "report/figures/headlines.hpp"

#include <fmt/core.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <optional>
#include <utility>

#include "core/mapped.hpp"
#include "grains/fields/laboratory/axial_tests.hpp"
#include "grains/fields/laboratory/test_numbers.hpp"
#include "report/page_document.hpp"
#include "thermal/inference/force_certainty.hpp"

namespace arenite::report::figures {

std::vector<Headline> headlines_of(fields::TestKind kind) {
  using enum fields::TestKind;
  switch (kind) {
    case none: return {};
    case biaxial:
      return {{"critical state", "q/p", "critical_state.q_over_p"},
              {"critical state", "\u03c6", "critical_state.solid_fraction"},
              {"peak", "q/p", "peak.q_over_p"},
              {"volumetric strain", "", "end.volumetric_strain", "%"}};
    case shear:
      return {{"critical state", "\u03bc", "critical_state.mu"},
              {"critical state", "\u03c6", "critical_state.solid_fraction"},
              {"peak", "\u03bc", "peak.mu"},
              {"volumetric strain", "", "end.volumetric_strain", "%"}};
    case uniaxial:
      return {{"strength", "\u03c3", "uniaxial.strength_Pa"},
              {"modulus", "E", "uniaxial.modulus_Pa"},
              {"strain at strength", "", "uniaxial.strain_at_strength", "%"},
              {"broken in tension", "", "uniaxial.broken.tension"},
              {"broken in bending", "", "uniaxial.broken.bending"},
              {"broken in shear", "", "uniaxial.broken.shear"}};
    case oedometer:
      return {{"constrained modulus", "M", "oedometer.modulus_Pa"},
              {"lateral stress ratio", "K", "oedometer.lateral_ratio"},
              {"axial strain", "", "oedometer.strain", "%"}};
    case cycles:
      return {{"accumulated strain", "", "cycles.accumulated_strain", "%"},
              {"strain amplitude", "", "cycles.strain_amplitude", "%"},
              {"volumetric strain since", "", "cycles.volumetric_strain", "%"},
              {"cycles", "N", "cycles.count"}};
    case discharge:
      return {{"discharge rate", "W", "discharge.rate_kg_s"},
              {"grains", "", "discharge.rate_grains_s"},
              {"opening", "", "discharge.opening_m"}};
    case collapse:
      return {{"run-out", "L", "surface.runout_m"},
              {"run-out over width", "", "surface.runout_over_width"},
              {"aspect ratio before", "a", "surface.aspect_ratio_before"},
              {"angle of repose", "\u03b8", "surface.angle_deg"}};
    case deposit: return {{"solid fraction", "\u03c6", "surface.solid_fraction"}, {"height", "h", "surface.top_m"}};
    case drum:
      return {{"mean angle", "\u03b8", "surface.mean_angle_deg"}, {"angle in the end", "\u03b8", "surface.angle_deg"}};
  }
  return {};
}

std::vector<Headline> headlines_of_grains(fields::TestKind kind) {
  using enum fields::TestKind;
  std::vector<Headline> list{{"solid fraction", "\u03c6", "solid_fraction"},
                             {"coordination", "z", "coordination.all"},
                             {"anisotropy", "a_{c}", "fabric.a_c"},
                             {"mean force", "\u27e8F_{n}\u27e9", "force.mean_N"},
                             {"strong contacts", "", "force.strong_share", "%"},
                             {"grains above mean", "P_{0}", "sigma_norm.P0", "%"}};
  constexpr fields::TestKind with_empty_box[] = {discharge, collapse, deposit, drum};
  if (std::ranges::count(with_empty_box, kind) > 0) list.erase(list.begin());
  return list;
}

namespace {

/// The number at a dotted name.
bool is_known(const Numbers& numbers, std::string path) {
  std::ranges::replace(path, '.', '/');
  const Numbers* at = numbers.at_path("/" + path);
  return at && at->is_known();
}

/// The first three of them that are known.
void add_known(std::vector<Headline>& to, const std::vector<Headline>& wanted, const Numbers& numbers) {
  std::size_t count = 0;
  for (const Headline& one : wanted)
    if (count < 3 && is_known(numbers, one.name)) to.push_back(one), ++count;
}

}  // namespace

std::vector<Headline> headlines_of(const FieldResult& field) {
  static constexpr const char* over_all = "\u27e8\u03c3_{yy}\u27e9/\u27e8\u03c3_{yy}\u27e9_{all}";
  const Headline modulus{"apparent modulus", "E", "modulus_Pa"};
  const std::vector<Headline> sample{{"grains", "\u03c1_{p}", "phases.particle", "%"},
                                     {"matrix in the pores", "S_{m}", "S_m", "%"},
                                     {"void", "\u03c1_{v}", "phases.void", "%"}},
      failure{modulus,
              {"strength", "", "strength_Pa"},
              {"strain at peak stress", "", "failure.strain_at_strength", "\u2030"}},
      response{modulus,
               {"mean stress", "\u27e8\u03c3_{yy}\u27e9", "stress.sigma_yy.sample_mean_Pa"},
               {"in large grains", over_all, "stress.sigma_yy.sets.large.mean_over_sample_mean"},
               {"in small grains", over_all, "stress.sigma_yy.sets.small.mean_over_sample_mean"},
               {"in grains", over_all, "stress.sigma_yy.sets.particle.mean_over_sample_mean"}};
  std::vector<Headline> list;
  add_known(list, sample, field.numbers);
  const auto* strain = field.curve.find("strain");
  if (strain && strain->size() > 1) add_known(list, failure, field.numbers);
  else if (field.field.size() > 0) add_known(list, response, field.numbers);
  return list;
}

std::vector<Headline> headlines_of(const VoxelResult& sample) {
  static constexpr const char* over_all = "\u27e8\u03c3_{zz}\u27e9/\u27e8\u03c3_{zz}\u27e9_{all}";
  std::vector<Headline> list;
  add_known(list,
            {{"grains", "\u03c1_{p}", "map.phases.particle", "%"},
             {"matrix", "\u03c1_{m}", "map.phases.matrix", "%"},
             {"void", "\u03c1_{v}", "map.phases.void", "%"}},
            sample.numbers);
  add_known(list,
            {{"apparent modulus", "E", "modulus_Pa"},
             {"strength", "", "strength_Pa"},
             {"strain at peak stress", "", "failure.strain_at_strength", "\u2030"},
             {"Young's modulus without clamps", "E_{iso}", "effective_stiffness.isotropic_mean_Pa.young"},
             {"in grains", over_all, "stress.sigma_zz.sets.particle.mean_over_sample_mean"},
             {"in the matrix", over_all, "stress.sigma_zz.sets.matrix.mean_over_sample_mean"}},
            sample.numbers);
  return list;
}

std::vector<Headline> headlines_of(const SphereResult& sample) {
  std::vector<Headline> list;
  add_known(list, headlines_of(fields::kind_of(sample)), sample.texture);
  for (const Headline& one : {Headline{"solid fraction", "\u03c6", "solid_fraction"},
                              {"contacts without rattlers", "z", "coordination.without_rattlers"},
                              {"pressure", "p", "stress_details.pressure_Pa"},
                              {"contacts", "z", "coordination.all"}})
    if (list.size() < 3 && is_known(sample.texture, one.name)) list.push_back(one);
  add_known(list,
            {{"deviator", "q", "stress_details.deviator_Pa"},
             {"anisotropy of contacts", "a_{c}", "fabric.a_c"},
             {"mean force", "\u27e8F_{n}\u27e9", "force.mean_N"}},
            sample.texture);
  return list;
}

std::vector<Headline> headlines_of(const FilmResult& film) {
  const auto plain = [](const char* words, std::string said, std::string behind = {}) {
    return Headline{words, "", "", "", std::move(said), std::move(behind)};
  };
  std::vector<Headline> list;
  for (const Headline& one :
       {Headline{"load frequency", "f", "lockin.frequency_Hz"},
        {"noise of a pixel", "", "lockin.standard_error_K"},
        {"grains", "N_{p}", "grains.all"},
        {"stress", "\u27e8\u03c3_{hyd}\u27e9", "stresses.film.mean_Pa"},
        {"force", "\u27e8F_{n}\u27e9", "forces.mean_N"},
        {"correlation with simulation", "r", "agreement.simulation_peak_to_peak.all.correlation"}})
    if (is_known(film.numbers, one.name)) list.push_back(one);
  if (const auto& forces = film.packing.contacts.fn; std::ranges::any_of(forces, [](double f) { return f != 0; })) {
    const auto sure = std::ranges::count(inference::doubtful_contacts(film), std::uint8_t{0});
    list.push_back(plain("certain contacts", counted(static_cast<double>(sure)),
                         "of " + counted(static_cast<double>(forces.size()))));
  }
  const std::size_t frames = film.maps.frames > 0 ? film.maps.frames : static_cast<std::size_t>(film.film.frames);
  list.push_back(plain("frames", counted(static_cast<double>(frames))));
  list.push_back(plain("pixels", fmt::format("{}\u202f\u00d7\u202f{}", film.film.width, film.film.height)));
  list.resize(list.size() >= 6 ? 6 : 3, list.back());
  return list;
}

std::string first_rows(const Numbers& numbers) {
  using enum fields::TestKind;
  std::string rows = "test_of_stage ";
  for (const auto kind : {biaxial, shear, uniaxial, oedometer, cycles, discharge, collapse, deposit, drum})
    for (const Headline& one : headlines_of(kind)) {
      const std::string_view name = one.name;
      const std::string group(name.substr(0, name.find('.') + 1));  // with the dot, so that no other begins like it
      if (rows.find(" " + group) == std::string::npos) rows += group + " ";
    }
  std::ranges::replace(rows, '.', ' ');
  return rows + "floor cohesion boundary_loads contacts wall_contacts " +
         (numbers.contains("surface") ? "" : "solid_fraction ") +
         "coordination.all coordination.without_rattlers coordination.all,* coordination.rattlers coordination.Z "
         "fabric.a_c long_axes.order long_axes.noise force.mean_N force.strong_share force.beta "
         "sigma_norm.P0 stress_details.pressure_Pa stress_details.deviator_Pa map.lengths grains.all phases.particle "
         "phases.void phases.matrix S_m pores.count pores.mean voids.count modulus_Pa poisson apparent_moduli "
         "strength_Pa "
         "failure.strain_at_strength stress.sigma_yy.sample_mean_Pa stress.sigma_yy.sets.*.mean_over_sample_mean "
         "map.voxels map.phases map.grains load.voxels.carrying load.voxels.floating effective_stiffness.young_Pa "
         "effective_stiffness.shear_Pa effective_stiffness.poisson effective_stiffness.isotropic_mean_Pa "
         "effective_stiffness.anisotropy effective_stiffness.bounds_Pa stress.sigma_zz.sets.*.mean_over_sample_mean "
         "stress.sigma_xz.sets.*.mean_over_sample_mean";
}

std::string_view first_of_studies(bool of_a_test) {
  return of_a_test ? "coordination.all fabric.a_c force.mean_N"
                   : "modulus_Pa strength_Pa poisson discharge.rate_kg_s surface.mean_angle_deg surface.angle_deg "
                     "surface.runout_over_width floor.pressure_Pa critical_state.mu critical_state.q_over_p "
                     "critical_state.solid_fraction solid_fraction coordination.all coordination.Z fabric.a_c "
                     "stress_details.pressure_Pa stress_details.deviator_Pa force.mean_N sigma_norm.P0 S_m "
                     "agreement.simulation_peak_to_peak.all.correlation stresses.film.mean_Pa forces.mean_N "
                     "forces.fn_error_N";
}

bool is_asked_for(std::string_view name) {
  return name == "discharge.opening_m" || name == "surface.aspect_ratio_before" || name == "cycles.count";
}

Numbers numbers_of(const std::vector<Headline>& list) {
  return mapped(list, [](const Headline& one) {
    return one.said.empty() ? Numbers::list({one.words, one.symbol, one.name, one.share})
                            : Numbers{{"words", one.words}, {"value", one.said}, {"unit", one.behind}};
  });
}

void add_test(Numbers& shown, const StageData& data) {
  const auto& [stage, states, before] = data;
  const fields::Test test{stage, before};
  Numbers numbers = fields::test_of(test);
  for (const char* name : {"loads", "discharge", "exchange", "surface", "floor"})
    if (const auto at = stage.texture.is_tree() ? stage.texture.find(name) : stage.texture.end();
        at != stage.texture.end())
      numbers[name] = *at;
  const fields::TestKind kind = fields::kind_of(test);
  shown["test"] = fields::name_of(kind);
  shown["headlines"] = numbers_of(headlines_of(kind));
  shown["headlines_of_grains"] = numbers_of(headlines_of_grains(kind));
  add_numbers(shown, numbers);
  const auto curves = fields::test_curves(test);
  const auto uniaxial = curves ? fields::uniaxial_test(*curves) : std::nullopt;
  if (!uniaxial || !uniaxial->failed || states.empty()) return;
  const double peak = (*stage.history.find("time"))[uniaxial->peak];
  const auto nearest =
      std::ranges::min_element(states, {}, [&](const Snapshot* s) { return std::abs(s->time - peak); });
  shown["opens"] = nearest - states.begin();
}

}  // namespace arenite::report::figures
