#include "report/test_curves.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "grains/dem/programme.hpp"
#include "grains/fields/stage_numbers.hpp"
#include "recipe/recipe.hpp"

namespace arenite::report {
namespace {

constexpr double least_strain = 2e-3;
constexpr double unloaded = 0.01;  // of the largest stress in the stage: ratios to less are noise

/// The stage as its recipe asked for it; nothing that is driven where another version wrote that.
dem::Stage asked_for(const StageResult& stage) {
  try {
    for (auto& one : recipe::parse_recipe(stage.provenance.recipe, "recipe").stages)
      if (one.name == stage.name) return one;
  } catch (const InputError&) {}
  return {};
}

/// How far a wall has slid along itself since the stage began, m, at every row: by its programme, or at its speed.
std::vector<double> slid(const dem::Stage& stage, int side, const std::vector<double>& time) {
  const auto& programmes = stage.programmes;
  const auto own =
      std::ranges::find_if(programmes, [&](const auto& p) { return p.of == dem::Programme::slide + side; });
  const double begin = stage.duration ? time.back() - *stage.duration : time.front();
  std::vector<double> way;
  for (const double t : time)
    way.push_back(own == programmes.end() ? stage.slide[side] * (t - begin) : dem::integral(*own, t - begin));
  return way;
}

/// Strain by two sides that slide: the difference of their ways over their distance, row by row. Empty where neither
/// slides.
std::vector<double> strain_between(const dem::Stage& stage, int one, int other, const std::vector<double>& time,
                                   const std::vector<double>& distance) {
  const auto near = slid(stage, one, time), far = slid(stage, other, time);
  std::vector<double> strain(time.size(), 0.0);
  bool slides = false;
  for (std::size_t k = 1; k < strain.size(); ++k) {
    const double way = (far[k] - far[k - 1]) - (near[k] - near[k - 1]);
    slides |= way != 0;
    strain[k] = strain[k - 1] + 0.5 * way * (1 / distance[k - 1] + 1 / distance[k]);
  }
  if (!slides) strain.clear();
  for (double& v : strain) v = std::abs(v);
  return strain;
}

/// Along the axis of compression of a confined sample, which may grow by more across it as it dilates; else along that
/// of the greater strain.
void strain_by_sides(TestCurves& curves, const fields::SideStresses& s) {
  const double x = 1 - s.width.back() / s.width.front(), y = 1 - s.height.back() / s.height.front();
  const bool upright = curves.confined ? y >= x : std::abs(y) >= std::abs(x);
  const auto& size = upright ? s.height : s.width;
  curves.strain_name = upright ? "strain of the height" : "strain of the width";
  for (const double v : size) curves.strain.push_back(1 - v / size.front());
}

/// a/b, NaN where b is all but nothing.
std::vector<double> ratio(const std::vector<double>& a, const std::vector<double>& b) {
  const double least = unloaded * *std::ranges::max_element(b);
  std::vector<double> result;
  for (std::size_t k = 0; k < a.size(); ++k)
    result.push_back(b[k] > least && b[k] > 0 ? std::abs(a[k]) / b[k] : statistics::unknown);
  return result;
}

/// A sample that grows along this size and pulls on its sides.
bool is_drawn(const std::vector<double>& size, const std::vector<double>& stress) {
  const auto [tension, pressure] = std::ranges::minmax(stress);
  return size.back() > (1 + least_strain) * size.front() && -tension > unloaded * std::abs(pressure);
}

/// The stress along the axis, Pa, of a test in which nothing presses across it, or which draws the sample apart;
/// nothing of any other.
std::optional<std::vector<double>> uniaxial_stress(const fields::SideStresses& s, double thickness) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    x.push_back(s.xx[k] / thickness);
    y.push_back(s.yy[k] / thickness);
  }
  const auto largest = [](const std::vector<double>& v) {
    return std::abs(*std::ranges::max_element(v, {}, [](double a) { return std::abs(a); }));
  };
  if (largest(x) <= unloaded * largest(y) || is_drawn(s.height, y)) return y;
  if (largest(y) <= unloaded * largest(x) || is_drawn(s.width, x)) return x;
  return {};
}

void take_ratio(TestCurves& curves, std::vector<double> shear, std::vector<double> normal) {
  curves.ratio = ratio(shear, normal);
  curves.shear = std::move(shear);
  curves.normal = std::move(normal);
}

/// Shear along the sides, in a cell that is sheared or between walls that slide. False where neither is.
bool strain_by_shear(TestCurves& curves, const StageResult& stage, const fields::SideStresses& s) {
  const dem::Stage asked = asked_for(stage);
  auto along_x = strain_between(asked, bottom, top, s.time, s.height),
       along_y = strain_between(asked, left, right, s.time, s.width);
  const bool upright = along_x.empty() && !along_y.empty();
  if (const auto* sheared = stage.history.find("shear_strain"))
    for (const double v : *sheared) curves.strain.push_back(std::abs(v - sheared->front()));
  else if (!along_x.empty() || upright) curves.strain = upright ? std::move(along_y) : std::move(along_x);
  else return false;
  curves.strain_name = "shear strain";
  curves.sheared = true;
  upright ? take_ratio(curves, s.along_y, s.xx) : take_ratio(curves, s.along_x, s.yy);
  return true;
}

/// Mean of the values from the first on, its error by blocks; where the series is too short to tell how long
/// independent ones are, the largest that six, four and three blocks give, with the freedom of three: blocks that still
/// depend on each other show less.
statistics::Measured over(const std::vector<double>& values, std::size_t first, bool& sure) {
  const auto plateau = std::span(values).subspan(first);
  statistics::Measured mean = fields::block_average(plateau).mean;
  if (std::isfinite(mean.error)) return mean;
  sure = false;
  mean.error = 0;
  for (const std::size_t blocks : {6, 4, 3}) {
    const statistics::Measured by_blocks = fields::mean_of_blocks(plateau, blocks);
    mean.error = std::max(mean.error, by_blocks.error);
    mean.freedom = by_blocks.freedom;
  }
  return mean;
}

Numbers with_interval(const statistics::Measured& m, const char* sentence) {
  const auto interval = statistics::confidence_95(m);
  return statistics::described(
      {{"value", m.value}, {"error", m.error}, {"low_95", interval.low}, {"high_95", interval.high}}, "", sentence);
}

}  // namespace

std::optional<TestCurves> test_curves(const StageResult& stage) {
  const auto s = fields::side_stresses(stage.history);
  if (!s || stage.snapshots.empty() || !(s->width.front() > 0) || !(s->height.front() > 0)) return {};
  TestCurves curves;
  if (!strain_by_shear(curves, stage, *s)) {
    auto stress = uniaxial_stress(*s, stage.snapshots.back().packing.domain.thickness);
    curves.confined = !stress;
    strain_by_sides(curves, *s);
    if (stress) curves.ratio = std::move(*stress);
    else take_ratio(curves, s->deviator(), s->pressure());
  }
  if (std::ranges::none_of(curves.strain, [](double v) { return std::abs(v) >= least_strain; })) return {};
  const double grains = stage.snapshots.back().packing.grains.area(), start = s->width.front() * s->height.front();
  for (std::size_t k = 0; k < s->time.size(); ++k) {
    const double area = s->width[k] * s->height[k];
    curves.volume.push_back(1 - area / start);
    curves.solid_fraction.push_back(grains / area);
  }
  return curves;
}

std::optional<CriticalState> critical_state(const TestCurves& curves) {
  if (!curves.confined) return {};
  const auto loaded = std::ranges::find_if(curves.ratio, [](double v) { return std::isfinite(v); });
  const auto offset = static_cast<std::size_t>(loaded - curves.ratio.begin());
  const std::vector<double> ratio(loaded, curves.ratio.end());
  const double last = curves.strain.back(), farthest = *std::ranges::max_element(curves.strain);
  if (ratio.size() < 60 || !(last >= 0.95 * farthest) ||
      std::ranges::any_of(ratio, [](double v) { return !std::isfinite(v); }))
    return {};
  const auto steady = fields::find_steady_state(ratio);
  const auto solid = fields::find_steady_state(std::span(curves.solid_fraction).subspan(offset));
  const std::size_t first = offset + std::max(steady.first, solid.first);
  if (!steady.settled || !solid.settled || last - curves.strain[first] < 0.2 * last) return {};
  CriticalState state{curves.strain[first], last, {}, {}};
  state.ratio = over(fields::about_ratio_of_means(curves.shear, curves.normal, first), 0, state.sure);
  state.solid_fraction = over(curves.solid_fraction, first, state.sure);
  return state;
}

Numbers numbers_of(const TestCurves& curves, const CriticalState& state) {
  return {
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
}

}  // namespace arenite::report
