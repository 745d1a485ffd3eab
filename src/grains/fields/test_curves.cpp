#include "grains/fields/test_curves.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/mapped.hpp"
#include "grains/fields/steady_state.hpp"

namespace arenite::fields {
namespace {

std::vector<double> sizes_of(const std::vector<double>& values) {
  return mapped(values, [](double v) { return std::abs(v); });
}

/// Mean of the values from the first on, its error by blocks; where the series is too short to tell how long
/// independent ones are, the largest that six, four and three blocks give, with the freedom of three: blocks that still
/// depend on each other show less.
statistics::Measured over(const std::vector<double>& values, std::size_t first, bool& sure) {
  const auto plateau = std::span(values).subspan(first);
  statistics::Measured mean = block_average(plateau).mean;
  if (std::isfinite(mean.error)) return mean;
  sure = false;
  mean.error = 0;
  for (const std::size_t blocks : {6, 4, 3}) {
    const statistics::Measured by_blocks = mean_of_blocks(plateau, blocks);
    mean.error = std::max(mean.error, by_blocks.error);
    mean.freedom = by_blocks.freedom;
  }
  return mean;
}

/// Whether loads press on both of a sample's axes, as its numbers say.
bool is_loaded_on_both_axes(const Numbers& numbers) {
  const auto presses = [&](int side) {
    return numbers.at_path(std::string("/loads/") + side_names[static_cast<std::size_t>(side)]) != nullptr;
  };
  return (presses(left) || presses(right)) && (presses(bottom) || presses(top));
}

double mean_size_from(const std::vector<double>& values, std::size_t first) {
  std::vector<double> known;
  for (std::size_t k = first; k < values.size(); ++k)
    if (std::isfinite(values[k])) known.push_back(std::abs(values[k]));
  return known.empty() ? statistics::unknown : statistics::mean_of(known).value;
}

Numbers with_interval(const statistics::Measured& m, const char* sentence) {
  const auto interval = statistics::confidence_95(m);
  return statistics::described(
      {{"value", m.value}, {"error", m.error}, {"low_95", interval.low}, {"high_95", interval.high}}, "", sentence);
}

}  // namespace

std::optional<TestCurves> test_curves(const Test& test) {
  const std::vector<double>* time = test.stage.history.find("time");
  auto of = time && time->size() > 2 ? loading_of(test) : std::nullopt;
  if (!of || (of->normal.empty() && !of->uniaxial)) return {};
  TestCurves curves;
  curves.sheared = of->sheared;
  curves.confined = !of->uniaxial;
  curves.strain_name = of->sheared ? "shear strain" : of->upright ? "strain of the height" : "strain of the width";
  curves.strain = of->sheared ? sizes_of(of->curves["shear_strain"]) : of->curves["axial_strain"];
  if (std::ranges::none_of(curves.strain, [](double v) { return std::abs(v) >= strain_of_a_test; })) return {};
  curves.ratio = of->sheared ? sizes_of(of->curves["mu"]) : of->curves[curves.ratio_name()];
  if (curves.confined) curves.shear = std::move(of->shear), curves.normal = std::move(of->normal);
  curves.volume = of->curves["volumetric_strain"];
  curves.solid_fraction = of->curves["solid_fraction"];
  curves.by_stress = !of->sheared && is_loaded_on_both_axes(test.stage.texture);
  if (const auto* inertial = of->curves.find("inertial_number")) curves.inertial_number = inertial->values;
  return curves;
}

std::vector<double> running_mean(const std::vector<double>& values) {
  const std::size_t rows = values.size() / 100;
  std::vector<double> sum{0}, count{0}, mean;
  for (const double v : values) {
    sum.push_back(sum.back() + (std::isfinite(v) ? v : 0));
    count.push_back(count.back() + (std::isfinite(v) ? 1 : 0));
  }
  for (std::size_t k = 0; k < values.size(); ++k) {
    const std::size_t half = std::min({rows / 2, k, values.size() - 1 - k});
    mean.push_back((sum[k + half + 1] - sum[k - half]) / (count[k + half + 1] - count[k - half]));
  }
  return mean;
}

std::vector<double> running_ratio(const TestCurves& curves) {
  if (curves.normal.empty()) return running_mean(curves.ratio);
  std::vector<double> ratio = running_mean(curves.shear);
  const std::vector<double> normal = running_mean(curves.normal);
  for (std::size_t k = 0; k < ratio.size(); ++k)
    ratio[k] = std::isfinite(curves.ratio[k]) ? std::abs(ratio[k]) / normal[k] : statistics::unknown;
  return ratio;
}

std::optional<CriticalState> critical_state(const TestCurves& curves) {
  if (!curves.confined || curves.by_stress) return {};
  const auto loaded = std::ranges::find_if(curves.ratio, [](double v) { return std::isfinite(v); });
  const auto offset = static_cast<std::size_t>(loaded - curves.ratio.begin());
  const std::vector<double> ratio(loaded, curves.ratio.end());
  const double last = curves.strain.back(), farthest = *std::ranges::max_element(curves.strain);
  if (ratio.size() < 60 || !(last >= 0.95 * farthest) ||
      std::ranges::any_of(ratio, [](double v) { return !std::isfinite(v); }))
    return {};
  const auto steady = find_steady_state(ratio);
  const auto solid = find_steady_state(std::span(curves.solid_fraction).subspan(offset));
  const std::size_t first = offset + std::max(steady.first, solid.first);
  if (!steady.settled || !solid.settled || last - curves.strain[first] < 0.2 * last) return {};
  CriticalState state{curves.strain[first], last, mean_size_from(curves.inertial_number, first), {}, {}};
  state.ratio = over(about_ratio_of_means(curves.shear, curves.normal, first), 0, state.sure);
  state.solid_fraction = over(curves.solid_fraction, first, state.sure);
  return state;
}

std::optional<Peak> peak_of(const TestCurves& curves, const std::optional<CriticalState>& state) {
  const std::vector<double> ratio = running_ratio(curves);
  const auto edge = static_cast<std::ptrdiff_t>(ratio.size() / 200);
  const auto critical =
      state ? std::ranges::find_if(curves.strain, [&](double v) { return v >= state->from; }) - curves.strain.begin()
            : std::ssize(ratio);
  const auto first = ratio.begin() + edge, last = ratio.begin() + std::min(critical, std::ssize(ratio) - edge);
  if (first >= last) return {};
  const auto known = [](double v) { return std::isfinite(v) ? v : -HUGE_VAL; };
  const auto peak = std::ranges::max_element(first, last, {}, known);
  if (!std::isfinite(*peak) || (state && !(*peak > statistics::confidence_95(state->ratio).high))) return {};
  return Peak{static_cast<std::size_t>(peak - ratio.begin()), *peak};
}

Numbers numbers_of(const TestCurves& curves, const CriticalState& state) {
  Numbers j{
      {"strain", curves.strain_name},
      {"from", statistics::described(state.from, "", "Strain beyond which the ratio and the volume only fluctuate")},
      {"to", statistics::described(state.to, "", "Last strain of the test")},
      {"sure", statistics::described(state.sure, "",
                                     "\"no\": too few fluctuations to tell the errors well, so that they and the "
                                     "intervals are wide; shear further or repeat with other seeds")},
      {curves.ratio_name(),
       with_interval(state.ratio, curves.sheared
                                      ? "Mean shear over mean normal stress on the sides in the critical state"
                                      : "Mean q over mean p in the critical state, from the forces on the sides")},
      {"solid_fraction",
       with_interval(state.solid_fraction, "Solid fraction of the whole box, mean over the critical state")}};
  if (std::isfinite(state.inertial_number))
    j["inertial_number"] =
        statistics::described(state.inertial_number, "",
                              "Mean inertial number there: quasi-static below 1e-3, a dense flow, whose ratio grows "
                              "with the rate, up to 0.1");
  return j;
}

}  // namespace arenite::fields
