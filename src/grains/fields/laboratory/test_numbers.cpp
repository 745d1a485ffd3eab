#include "grains/fields/laboratory/test_numbers.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "grains/fields/laboratory/axial_tests.hpp"
#include "grains/fields/laboratory/test_in_space.hpp"
#include "grains/fields/laboratory/test_kind.hpp"
#include "grains/fields/state_curves.hpp"

namespace arenite::fields {
namespace {

using statistics::described;
using Values = std::vector<double>;

Numbers peak_numbers(const TestCurves& curves, const std::optional<CriticalState>& state) {
  const auto peak = peak_of(curves, state);
  if (!peak) return {};
  return {
      {curves.ratio_name(),
       described(peak->ratio, "", "Largest ratio of stresses, each the mean over a hundredth of the test")},
      {"strain", described(curves.strain[peak->row], "", "Strain there")},
      {"volumetric_strain", described(curves.volume[peak->row], "", "Volumetric strain there, compaction positive")}};
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

Numbers uniaxial_numbers(const History& history, const UniaxialTest& test) {
  Numbers j{{"strength_Pa", described(test.strength, "Pa",
                                      "Largest stress along the axis that the sample bore; of one sample, so that its "
                                      "error is not known")},
            {"strain_at_strength", described(test.strain, "", "Strain along the axis there")},
            {"failed", described(test.failed, "", "Whether the stress has fallen by a tenth since")},
            {"in_tension", described(test.in_tension, "", "Whether the sample was drawn apart")}};
  statistics::put(j, "modulus_Pa", test.modulus, "Pa",
                  "Slope of stress over strain from a tenth to half of the strength; of one sample, so that its error "
                  "is not known");
  const std::size_t last = history.columns.front().values.size() - 1;
  Numbers broken = broken_up_to(history, last, "Bonds between grains that broke in the stage");
  if (broken.empty()) return j;
  j["broken"] = std::move(broken);
  j["broken_at_strength"] = broken_up_to(history, test.peak, "Those that had broken at the largest stress");
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

void put_known(Numbers& j, const char* name, Numbers numbers) {
  if (!numbers.empty()) j[name] = std::move(numbers);
}

/// What curves tell, of disks and of spheres.
void put_found(Numbers& j, const TestCurves& curves, TestKind kind, const History& history) {
  const auto state = critical_state(curves);
  if (state) put_known(j, "critical_state", numbers_of(curves, *state));
  if (kind == TestKind::biaxial || kind == TestKind::shear) {
    put_known(j, "peak", peak_numbers(curves, state));
    put_known(j, "end", end_numbers(curves));
  }
  if (const auto uniaxial = uniaxial_test(curves)) put_known(j, "uniaxial", uniaxial_numbers(history, *uniaxial));
}

}  // namespace

Numbers test_numbers(const Test& test) {
  Numbers j = Numbers::tree();
  const TestKind kind = kind_of(test);
  if (kind == TestKind::cycles) put_known(j, "cycles", cycle_numbers(test));
  const auto curves = test_curves(test);
  if (!curves) return j;
  put_found(j, *curves, kind, test.stage.history);
  if (kind == TestKind::oedometer)
    if (const auto oedometer = oedometer_test(test, *curves)) put_known(j, "oedometer", oedometer_numbers(*oedometer));
  return j;
}

Numbers test_numbers(const SphereResult& stage) {
  Numbers j = Numbers::tree();
  if (const auto curves = test_curves(stage)) put_found(j, *curves, kind_of(stage), stage.history);
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

Numbers test_of(const SphereResult& stage) {
  Numbers stored = test_among(stage.texture);
  return stored.empty() ? test_numbers(stage) : stored;
}

}  // namespace arenite::fields
