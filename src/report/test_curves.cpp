#include "report/test_curves.hpp"

#include <algorithm>
#include <cmath>
#include <span>
#include <utility>

#include "core/error.hpp"
#include "recipe/recipe.hpp"

namespace arenite::report {
namespace {

constexpr double least_strain = 2e-3;
constexpr double unloaded = 0.01;  // of the largest stress in the stage: ratios to less are noise

struct Sides {
  std::vector<double> time, width, height;  ///< s, m
  std::vector<double> normal_x, normal_y;   ///< mean forces on the sides, N
  std::vector<double> along_x, along_y;     ///< half the difference of the shear forces on bottom and top, on left and right, N
};

/// A sum of two columns with these weights; zeros where there is none.
std::vector<double> weighed(const History& history, double x, const std::string& one, double y, const std::string& other, std::size_t rows) {
  std::vector<double> result(rows, 0.0);
  const auto *a = history.find(one), *b = history.find(other);
  for (std::size_t k = 0; k < rows; ++k) result[k] = x * (a ? (*a)[k] : 0) + y * (b ? (*b)[k] : 0);
  return result;
}

std::optional<Sides> sides_of(const History& history) {
  const auto* time = history.find("time");
  if (!time || time->size() < 3) return {};
  const std::size_t rows = time->size();
  for (const char* side : side_names)
    if (!history.find(std::string(side) + "_position")) return {};
  Sides s;
  s.time = *time;
  s.width = weighed(history, 1, "right_position", -1, "left_position", rows);
  s.height = weighed(history, 1, "top_position", -1, "bottom_position", rows);
  s.normal_x = weighed(history, 0.5, "left_force", 0.5, "right_force", rows);
  s.normal_y = weighed(history, 0.5, "bottom_force", 0.5, "top_force", rows);
  s.along_x = weighed(history, 0.5, "bottom_shear_force", -0.5, "top_shear_force", rows);
  s.along_y = weighed(history, 0.5, "left_shear_force", -0.5, "right_shear_force", rows);
  return s;
}

/// How fast each wall slides along itself, as the stage's recipe says.
std::array<double, 4> slide_of(const StageResult& stage) {
  try {
    for (const auto& one : recipe::parse_recipe(stage.provenance.recipe, "recipe").stages)
      if (one.name == stage.name) return one.slide;
  } catch (const InputError&) {}
  return {};
}

/// Strain by sides that slide at these speeds: the rate is their difference over their distance.
std::vector<double> slid(const Sides& s, double difference, const std::vector<double>& distance) {
  std::vector<double> strain(s.time.size(), 0.0);
  for (std::size_t k = 1; k < strain.size(); ++k)
    strain[k] = strain[k - 1] + 0.5 * difference * (1 / distance[k - 1] + 1 / distance[k]) * (s.time[k] - s.time[k - 1]);
  return strain;
}

/// Along the axis of compression of a confined sample, which may grow by more across it as it dilates; else along that of the greater strain.
void strain_by_sides(TestCurves& curves, const Sides& s) {
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
  for (std::size_t k = 0; k < a.size(); ++k) result.push_back(b[k] > least && b[k] > 0 ? std::abs(a[k]) / b[k] : statistics::unknown);
  return result;
}

std::vector<double> q_over_p(const Sides& s) {
  std::vector<double> p, q;
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    const double xx = s.normal_x[k] / s.height[k], yy = s.normal_y[k] / s.width[k], tau = s.along_x[k] / s.width[k];
    p.push_back(0.5 * (xx + yy));
    q.push_back(std::hypot(0.5 * (xx - yy), tau));
  }
  return ratio(q, p);
}

/// A sample that grows along this size and pulls on its sides.
bool is_drawn(const std::vector<double>& size, const std::vector<double>& stress) {
  const auto [tension, pressure] = std::ranges::minmax(stress);
  return size.back() > (1 + least_strain) * size.front() && -tension > unloaded * std::abs(pressure);
}

/// The stress along the axis, Pa, of a test in which nothing presses across it, or which draws the sample apart; nothing of any other.
std::optional<std::vector<double>> uniaxial_stress(const Sides& s, double thickness) {
  std::vector<double> x, y;
  for (std::size_t k = 0; k < s.time.size(); ++k) {
    x.push_back(s.normal_x[k] / (s.height[k] * thickness));
    y.push_back(s.normal_y[k] / (s.width[k] * thickness));
  }
  const auto largest = [](const std::vector<double>& v) { return std::abs(*std::ranges::max_element(v, {}, [](double a) { return std::abs(a); })); };
  if (largest(x) <= unloaded * largest(y) || is_drawn(s.height, y)) return y;
  if (largest(y) <= unloaded * largest(x) || is_drawn(s.width, x)) return x;
  return {};
}

/// Shear along the sides, in a cell that is sheared or between walls that slide. False where neither is.
bool strain_by_shear(TestCurves& curves, const StageResult& stage, const Sides& s) {
  const auto slide = slide_of(stage);
  const double along_x = slide[top] - slide[bottom], along_y = slide[right] - slide[left];
  if (const auto* sheared = stage.history.find("shear_strain"))
    for (const double v : *sheared) curves.strain.push_back(std::abs(v - sheared->front()));
  else if (along_x != 0 || along_y != 0) curves.strain = along_x != 0 ? slid(s, std::abs(along_x), s.height) : slid(s, std::abs(along_y), s.width);
  else return false;
  curves.strain_name = "shear strain";
  curves.sheared = true;
  curves.ratio = along_x == 0 && along_y != 0 ? ratio(s.along_y, s.normal_x) : ratio(s.along_x, s.normal_y);
  return true;
}

/// Mean of the values from the first on, its error by blocks; of six where the series is too short to tell how long independent ones are.
statistics::Measured over(const std::vector<double>& values, std::size_t first, bool& sure) {
  const auto plateau = std::span(values).subspan(first);
  const statistics::Measured mean = fields::block_average(plateau).mean;
  if (std::isfinite(mean.error)) return mean;
  sure = false;
  return fields::mean_of_blocks(plateau, 6);
}

Numbers with_interval(const statistics::Measured& m, const char* sentence) {
  const auto interval = statistics::confidence_95(m);
  return statistics::described({{"value", m.value}, {"error", m.error}, {"low_95", interval.low}, {"high_95", interval.high}}, "", sentence);
}

}  // namespace

std::optional<TestCurves> test_curves(const StageResult& stage) {
  const auto s = sides_of(stage.history);
  if (!s || stage.snapshots.empty() || !(s->width.front() > 0) || !(s->height.front() > 0)) return {};
  TestCurves curves;
  if (!strain_by_shear(curves, stage, *s)) {
    auto stress = uniaxial_stress(*s, stage.snapshots.back().packing.domain.thickness);
    curves.confined = !stress;
    strain_by_sides(curves, *s);
    curves.ratio = stress ? std::move(*stress) : q_over_p(*s);
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
  if (ratio.size() < 60 || !(last >= 0.95 * farthest) || std::ranges::any_of(ratio, [](double v) { return !std::isfinite(v); })) return {};
  const auto steady = fields::find_steady_state(ratio);
  const auto solid = fields::find_steady_state(std::span(curves.solid_fraction).subspan(offset));
  const std::size_t first = offset + std::max(steady.first, solid.first);
  if (!steady.settled || !solid.settled || last - curves.strain[first] < 0.2 * last) return {};
  CriticalState state{curves.strain[first], last, {}, {}};
  state.ratio = over(curves.ratio, first, state.sure);
  state.solid_fraction = over(curves.solid_fraction, first, state.sure);
  return state;
}

Numbers numbers_of(const TestCurves& curves, const CriticalState& state) {
  return {{"strain", curves.strain_name},
          {"from", statistics::described(state.from, "", "Strain beyond which the ratio and the volume only fluctuate")},
          {"to", statistics::described(state.to, "", "Last strain of the test")},
          {"sure", statistics::described(state.sure, "", "\"no\": errors are from six blocks, perhaps too small; shear further or repeat with other seeds")},
          {curves.ratio_name(), with_interval(state.ratio, curves.sheared ? "Shear over normal stress on the sides, mean over the critical state"
                                                                          : "q/p from the forces on the sides, mean over the critical state")},
          {"solid_fraction", with_interval(state.solid_fraction, "Solid fraction of the whole box, mean over the critical state")}};
}

}  // namespace arenite::report
