#include "report/figures/headlines.hpp"

#include <algorithm>
#include <cmath>

#include "core/mapped.hpp"
#include "grains/fields/laboratory/axial_tests.hpp"
#include "grains/fields/laboratory/test_numbers.hpp"
#include "report/page_document.hpp"

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

void add_test(Numbers& shown, const StageData& data) {
  const auto& [stage, states, before] = data;
  const fields::Test test{stage, before};
  Numbers numbers = fields::test_numbers(test);
  for (const char* name : {"loads", "discharge", "exchange", "surface", "floor"})
    if (const auto at = stage.texture.is_tree() ? stage.texture.find(name) : stage.texture.end();
        at != stage.texture.end())
      numbers[name] = *at;
  const fields::TestKind kind = fields::kind_of(test);
  shown["test"] = fields::name_of(kind);
  shown["headlines"] = mapped(headlines_of(kind), [](const Headline& one) {
    return Numbers::list({one.words, one.symbol, one.name, one.share});
  });
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
