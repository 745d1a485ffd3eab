#include "grains/fields/laboratory/test_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grains/fields/laboratory/axial_tests.hpp"
#include "grains/fields/laboratory/test_kind.hpp"
#include "grains/fields/state_curves.hpp"

namespace arenite::fields {
namespace {

using statistics::described;
using Values = std::vector<double>;

/// The largest ratio of stresses on the way to the critical state, where it is above all that this may be. Rows at the
/// ends, whose means are of few, do not count.
Numbers peak_numbers(const TestCurves& curves, const std::optional<CriticalState>& state) {
  const Values ratio = running_ratio(curves);
  const auto edge = static_cast<std::ptrdiff_t>(ratio.size() / 200);
  const auto critical =
      state ? std::ranges::find_if(curves.strain, [&](double v) { return v >= state->from; }) - curves.strain.begin()
            : std::ssize(ratio);
  const auto first = ratio.begin() + edge, last = ratio.begin() + std::min(critical, std::ssize(ratio) - edge);
  if (first >= last) return {};
  const auto known = [](double v) { return std::isfinite(v) ? v : -HUGE_VAL; };
  const auto peak = std::ranges::max_element(first, last, {}, known);
  if (!std::isfinite(*peak) || (state && !(*peak > statistics::confidence_95(state->ratio).high))) return {};
  const auto row = static_cast<std::size_t>(peak - ratio.begin());
  return {{curves.ratio_name(),
           described(*peak, "", "Largest ratio of stresses, each the mean over a hundredth of the test")},
          {"strain", described(curves.strain[row], "", "Strain there")},
          {"volumetric_strain", described(curves.volume[row], "", "Volumetric strain there, compaction positive")}};
}

Numbers end_numbers(const TestCurves& curves) {
  return {{"strain", described(curves.strain.back(), "", "Strain in the end")},
          {"volumetric_strain", described(curves.volume.back(), "", "Volumetric strain there, compaction positive")}};
}

/// Bonds that have broken up to a row of the history, by failure mode; empty where grains have none.
Numbers broken_up_to(const History& history, std::size_t row, const char* sentence) {
  Numbers broken = Numbers::tree();
  double sum = 0;
  for (const char* mode : {"tension", "bending", "shear"})
    if (const Values* count = history.find(std::string("broken_in_") + mode)) {
      broken[mode] = described((*count)[row], "", sentence);
      sum += (*count)[row];
    }
  if (!broken.empty()) broken["all"] = described(sum, "", sentence);
  return broken;
}

Numbers uniaxial_numbers(const StageResult& stage, const UniaxialTest& test) {
  Numbers j{{"strength_Pa", described(test.strength, "Pa",
                                      "Largest stress along the axis that the sample bore; of one sample, so that its "
                                      "error is not known")},
            {"strain_at_strength", described(test.strain, "", "Strain along the axis there")},
            {"failed", described(test.failed, "", "Whether the stress has fallen by a tenth since")},
            {"in_tension", described(test.in_tension, "", "Whether the sample was drawn apart")}};
  statistics::put(j, "modulus_Pa", test.modulus, "Pa",
                  "Slope of stress over strain from a tenth to half of the strength; of one sample, so that its error "
                  "is not known");
  const std::size_t last = stage.history.columns.front().values.size() - 1;
  Numbers broken = broken_up_to(stage.history, last, "Bonds between grains that broke in the stage");
  if (broken.empty()) return j;
  j["broken"] = std::move(broken);
  j["broken_at_strength"] = broken_up_to(stage.history, test.peak, "Those that had broken at the largest stress");
  return j;
}

Numbers oedometer_numbers(const OedometerTest& test) {
  Numbers j{
      {"stress_Pa", described(test.stress, "Pa", "Stress along the axis in the end")},
      {"strain", described(test.strain, "", "Strain along the axis in the end")},
      {"lateral_ratio", described(test.lateral_ratio, "", "Stress across the axis over that along it in the end")}};
  statistics::put(j, "modulus_Pa", test.modulus, "Pa",
                  "Constrained modulus, slope of stress over strain from half of the largest stress; of one sample, so "
                  "that its error is not known");
  return j;
}

Numbers cycle_numbers(const Test& test) {
  const auto* noted = test.stage.cycles.find("cycle");
  if (!noted || noted->size() < 4 || !loading_of(test)) return {};
  const statistics::Columns found = every_cycle(test);
  const std::string strain = loading_of(test)->sheared ? "shear_strain" : "axial_strain";
  const Values &high = found[strain + "_maximum"], &low = found[strain + "_minimum"],
               &volume = found["volumetric_strain_minimum"];
  return {{"count", described(high.size(), "", "Number of whole cycles")},
          {"strain_amplitude",
           described(std::abs(high.back() - low.back()), "", "Strain from end to end in the last cycle")},
          {"accumulated_strain",
           described(low.back() - low.front(), "", "Strain at the smallest load since the end of the first cycle")},
          {"volumetric_strain",
           described(volume.back() - volume.front(), "", "The same of the volumetric strain, compaction positive")}};
}

}  // namespace

Numbers test_numbers(const Test& test) {
  Numbers j = Numbers::tree();
  const auto put = [&j](const char* name, Numbers numbers) {
    if (!numbers.empty()) j[name] = std::move(numbers);
  };
  const TestKind kind = kind_of(test);
  if (kind == TestKind::cycles) put("cycles", cycle_numbers(test));
  const auto curves = test_curves(test);
  if (!curves) return j;
  const auto state = critical_state(*curves);
  if (state) put("critical_state", numbers_of(*curves, *state));
  if (kind == TestKind::biaxial || kind == TestKind::shear) {
    put("peak", peak_numbers(*curves, state));
    put("end", end_numbers(*curves));
  }
  if (const auto uniaxial = uniaxial_test(*curves)) put("uniaxial", uniaxial_numbers(test.stage, *uniaxial));
  if (kind == TestKind::oedometer)
    if (const auto oedometer = oedometer_test(test, *curves)) put("oedometer", oedometer_numbers(*oedometer));
  return j;
}

Numbers test_among(const Numbers& stored) {
  Numbers found = Numbers::tree();
  if (!stored.is_tree()) return found;
  for (const char* name : {"cycles", "critical_state", "peak", "end", "uniaxial", "oedometer"})
    if (const auto at = stored.find(name); at != stored.end()) found[name] = *at;
  return found;
}

Numbers test_of(const Test& test) {
  Numbers stored = test_among(test.stage.texture);
  return stored.empty() ? test_numbers(test) : stored;
}

}  // namespace arenite::fields
