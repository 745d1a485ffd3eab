#include "grains/fields/loading.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"
#include "grains/fields/discharge.hpp"
#include "grains/fields/laboratory/tested_stage.hpp"
#include "grains/fields/regime/prediction.hpp"
#include "grains/fields/stage_numbers.hpp"

namespace arenite::fields {
namespace {

using statistics::Columns;
using Values = std::vector<double>;

constexpr double least_strain = 2e-3;
constexpr double unloaded = 0.01;  // of the largest stress in the stage: ratios to less are noise

/// What strains refer to.
struct Start {
  double width = 0, height = 0;
};

Start start_of(const Test& test, const SideStresses& s) {
  if (test.before) return {test.before->domain.width(), test.before->domain.height()};
  return {s.width.front(), s.height.front()};
}

Values shortening(const Values& size, double start) {
  return mapped(size, [&](double now) { return 1 - now / start; });
}

/// Of a cell that is sheared or between walls that slide; empty where neither is.
struct Shear {
  Values strain;
  bool along_y = false;  ///< by left and right alone
};

Shear shear_of(const History& rows, const History& since, const SideStresses& s) {
  if (const Values* cell = rows.find("shear_strain")) {
    const Values* first = since.find("shear_strain");
    return {mapped(*cell, [&](double v) { return v - (first ? first : cell)->front(); })};
  }
  Values along_x = strain_between(rows, since, bottom, top, s.height),
         along_y = strain_between(rows, since, left, right, s.width);
  if (along_x.empty()) return {along_y, !along_y.empty()};
  for (std::size_t k = 0; k < along_y.size(); ++k) along_x[k] += along_y[k];
  return {along_x};
}

double largest(const Values& v) {
  return std::abs(*std::ranges::max_element(v, {}, [](double a) { return std::abs(a); }));
}

bool any(const Values& v) {
  return std::ranges::any_of(v, [](double a) { return a != 0; });
}

/// A sample that grows along this size and pulls on its sides.
bool is_drawn(const Values& size, const Values& stress) {
  const auto [tension, pressure] = std::ranges::minmax(stress);
  return size.back() > (1 + least_strain) * size.front() && -tension > unloaded * std::abs(pressure);
}

/// The stress along the axis of a test in which nothing presses across it, or which draws the sample apart; null of any
/// other.
const Values* uniaxial_stress(const SideStresses& s, const Values& xx, const Values& yy) {
  if (!any(xx) && !any(yy)) return nullptr;
  if (largest(xx) <= unloaded * largest(yy) || is_drawn(s.height, yy)) return &yy;
  if (largest(yy) <= unloaded * largest(xx) || is_drawn(s.width, xx)) return &xx;
  return nullptr;
}

/// By the shortening of every axis.
template <std::size_t D> Values volume_lost(const std::array<Values, D>& strains) {
  Values volume;
  for (std::size_t k = 0; k < strains[0].size(); ++k) {
    double left = 1;
    for (const Values& along : strains) left *= 1 - along[k];
    volume.push_back(1 - left);
  }
  return volume;
}

/// Of the box of every state along the axes.
template <int D>
std::array<Values, static_cast<std::size_t>(D)> shortening(const std::vector<SnapshotIn<D>>& states,
                                                           const Vec<D>& before) {
  std::array<Values, static_cast<std::size_t>(D)> of;
  for (int axis = 0; axis < D; ++axis)
    of[axis] = mapped(states, [&](const auto& state) { return 1 - state.packing.domain.extent(axis) / before[axis]; });
  return of;
}

void put_strains(const Loading& of, const Values& x, const Values& y, const Values& shear, Columns& to) {
  const Values &axial = of.upright ? y : x, &lateral = of.upright ? x : y;
  Values deviator = shear;
  for (std::size_t k = 0; k < x.size(); ++k)
    if (!of.sheared) deviator.push_back(axial[k] - lateral[k]);
  to.put("strain_x", "", "Shortening of the width over the width before the stage", x);
  to.put("strain_y", "", "Shortening of the height over the height before the stage", y);
  to.put("axial_strain", "", "Strain along the axis of compression", axial);
  to.put("volumetric_strain", "", "Decrease of the box's area over the area before the stage",
         volume_lost(std::array{x, y}));
  to.put("shear_strain", "",
         of.sheared ? "Shear strain of the cell, or by the walls that slide, since the first row"
                    : "Axial minus lateral strain",
         std::move(deviator));
}

void put_stresses(Loading& of, const SideStresses& s, double thickness) {
  const auto pascal = [&](const Values& v) { return mapped(v, [&](double a) { return a / thickness; }); };
  const Values xx = pascal(s.xx), yy = pascal(s.yy), tau = pascal(of.along_y ? s.along_y : s.along_x);
  Columns& to = of.curves;
  if (any(xx)) to.put("sigma_xx", "Pa", "Mean normal stress on left and right, compression positive", xx);
  if (any(yy)) to.put("sigma_yy", "Pa", "Mean normal stress on bottom and top, compression positive", yy);
  if (!any(xx) && !any(yy)) return;
  if (any(tau))
    to.put("tau", "Pa", "Shear stress along the sides, positive where the top, or the right, is held back", tau);
  if (any(xx) && any(yy)) {
    Values p, q;
    for (std::size_t k = 0; k < xx.size(); ++k) {
      p.push_back(0.5 * (xx[k] + yy[k]));
      q.push_back(mohr_radius({xx[k], tau[k], tau[k], yy[k]}));
    }
    to.put("p", "Pa", "Mean of the two normal stresses on the sides", p);
    to.put("q", "Pa", "Half the difference of the principal stresses on the sides", q);
    to.put("q_over_p", "", "q over p: the sine of the mobilised angle of friction", loaded_ratio(q, p));
    of.shear = std::move(q), of.normal = std::move(p);
  }
  if (of.sheared) {
    of.shear = tau, of.normal = of.along_y ? xx : yy;
    to.put("mu", "", "Shear over normal stress on the sheared sides, negative for shear to the left",
           loaded_ratio(of.shear, of.normal));
  }
}

void put_density(Loading& of, const SideStresses& s, const Packing& packing) {
  const double grains = packing.grains.area();
  Values solid;
  for (std::size_t k = 0; k < s.time.size(); ++k) solid.push_back(grains / (s.width[k] * s.height[k]));
  of.curves.put("solid_fraction", "", "Area of grains over that of the whole box", std::move(solid));
}

/// By the pressure on the sheared plane, or p.
void put_inertial_number(Loading& of, const Packing& packing) {
  const statistics::Column* p = of.curves.find("p");
  if (!of.sheared && !p) return;
  const Values& pressure = of.sheared ? of.normal : p->values;
  const auto has_density = [&](std::int32_t m) { return static_cast<std::size_t>(m) < packing.materials.size(); };
  if (pressure.empty() || packing.grains.size() == 0 || !std::ranges::all_of(packing.grains.material, has_density))
    return;
  of.curves.put(
      "inertial_number", "",
      "Rate of shear times mean diameter over sqrt(pressure/density) (GDR MiDi, Eur. Phys. J. E 14, 341, 2004)",
      inertial_numbers(of.curves["shear_strain"], of.curves["time"], pressure, packing));
}

/// Axis along which the sample is compressed: that of a confined one, which may grow by more across it as it dilates,
/// else that of the greater strain.
bool is_upright(double x, double y, bool confined) { return confined ? y >= x : std::abs(y) >= std::abs(x); }

}  // namespace

Values strain_between(const History& rows, const History& since, int one, int other, const Values& distance) {
  const auto way_in = [&](const History& of, std::size_t k) {
    double way = 0;
    for (const int side : {one, other})
      if (const Values* slid = of.find(std::string(any_side_names[static_cast<std::size_t>(side)]) + "_slid"))
        way += (side == other ? 1 : -1) * (*slid)[k];
    return way;
  };
  Values strain(distance.size(), 0.0);
  bool slides = false;
  double before = way_in(since, 0), inverse = 1 / distance.front(), sum = 0;
  for (std::size_t k = 0; k < strain.size(); ++k) {
    const double way = way_in(rows, k);
    slides |= way != before;
    strain[k] = sum += 0.5 * (way - before) * (inverse + 1 / distance[k]);
    before = way, inverse = 1 / distance[k];
  }
  if (!slides) strain.clear();
  return strain;
}

Values rate_of(const Values& value, const Values& time) {
  const std::size_t n = value.size();
  const auto slope = [&](std::size_t k) { return (value[k + 1] - value[k]) / (time[k + 1] - time[k]); };
  Values rate(n, 0.0);
  rate.front() = slope(0), rate.back() = slope(n - 2);
  for (std::size_t k = 1; k + 1 < n; ++k) {
    const double to = time[k + 1] - time[k], from = time[k] - time[k - 1];
    rate[k] = (from * slope(k) + to * slope(k - 1)) / (from + to);
  }
  return rate;
}

template <int D>
Values inertial_numbers(const Values& strain, const Values& time, const Values& pressure, const PackingIn<D>& packing) {
  const double diameter = packing.grains.mean_diameter(), density = mean_density(packing);
  const Values rate = rate_of(strain, time);
  Values number;
  for (std::size_t k = 0; k < rate.size(); ++k)
    number.push_back(inertial_number(rate[k], diameter, density, pressure[k]));
  return number;
}
template Values inertial_numbers(const Values&, const Values&, const Values&, const PackingIn<2>&);
template Values inertial_numbers(const Values&, const Values&, const Values&, const PackingIn<3>&);

Values loaded_ratio(const Values& a, const Values& b) {
  const double least = unloaded * *std::ranges::max_element(b);
  Values result;
  for (std::size_t k = 0; k < a.size(); ++k)
    result.push_back(b[k] > least && b[k] > 0 ? a[k] / b[k] : statistics::unknown);
  return result;
}

std::optional<Loading> loading_in(const History& rows, const Test& test) {
  const auto s = side_stresses(rows);
  if (!s || test.stage.snapshots.empty() || !(s->width.front() > 0) || !(s->height.front() > 0)) return {};
  const Packing& packing = test.stage.snapshots.back().packing;
  Loading of;
  of.curves.put("time", "s", "Time since the first row",
                mapped(s->time, [&](double t) { return t - s->time.front(); }));
  const Start start = start_of(test, *s);
  const Shear shear = shear_of(rows, test.stage.history, *s);
  const Values x = shortening(s->width, start.width), y = shortening(s->height, start.height);
  const Values* axial = uniaxial_stress(*s, s->xx, s->yy);
  of.sheared = !shear.strain.empty();
  of.uniaxial = axial && !of.sheared;
  of.upright = is_upright(x.back(), y.back(), !of.uniaxial);
  of.along_y = shear.along_y;
  put_strains(of, x, y, shear.strain, of.curves);
  const double thickness = packing.domain.thickness;
  put_stresses(of, *s, thickness);
  if (of.uniaxial)
    of.curves.put("axial_stress", "Pa",
                  "Stress along the axis of a test that is not confined, or draws the sample apart",
                  mapped(*axial, [&](double v) { return v / thickness; }));
  put_density(of, *s, packing);
  put_inertial_number(of, packing);
  put_discharge_rates(rows, s->time, of.curves);
  for (auto& energy : energies_of(rows).list) of.curves.list.push_back(std::move(energy));
  return of;
}

std::optional<Loading> loading_of(const Test& test) {
  if (!has_history(test.stage)) return {};
  return loading_in(test.stage.history, test);
}

Columns strains_of_states(const Test& test) {
  Columns found;
  const auto of = loading_of(test);
  if (!of) return found;
  const auto s = *side_stresses(test.stage.history);
  const Start start = start_of(test, s);
  const auto [x, y] = shortening(test.stage.snapshots, {start.width, start.height});
  Values time, shear;
  for (const Snapshot& state : test.stage.snapshots) {
    time.push_back(state.time - s.time.front());
    if (of->sheared) shear.push_back(at_time(of->curves["time"], of->curves["shear_strain"], time.back()));
  }
  found.put("time", "s", "Time since the first row of the history", std::move(time));
  put_strains(*of, x, y, shear, found);
  return found;
}

template <int D> Columns strains_of_boxes(const StageResultIn<D>& stage, const DomainIn<D>& before) {
  const auto strains = shortening(stage.snapshots, by_axis<D>([&](int axis) { return before.extent(axis); }));
  Columns found;
  for (int axis = 0; axis < D; ++axis)
    found.put(std::string("strain_") + "xyz"[axis], "", "Shortening of the box since the state before the stage",
              strains[axis]);
  found.put("volumetric_strain", "", "Decrease of the box since then over what it was", volume_lost(strains));
  return found;
}
template Columns strains_of_boxes(const StageResult&, const Domain&);
template Columns strains_of_boxes(const SphereResult&, const DomainIn<3>&);

double at_time(const Values& time, const Values& values, double t) {
  const auto after = static_cast<std::size_t>(std::ranges::lower_bound(time, t) - time.begin());
  if (after == 0) return values.front();
  if (after == time.size()) return values.back();
  const double share = (t - time[after - 1]) / (time[after] - time[after - 1]);
  return values[after - 1] + share * (values[after] - values[after - 1]);
}

}  // namespace arenite::fields
