#include "report/packing_layers.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/error.hpp"
#include "grains/fields/coarse_grained.hpp"
#include "grains/packing/size_curve.hpp"
#include "recipe/recipe.hpp"

namespace arenite::report {
namespace {

constexpr double most_cells = 2500;

double mean_diameter(const Grains& grains) {
  return 2 * std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0) / static_cast<double>(std::max<std::size_t>(1, grains.size()));
}

const std::vector<double>* column(const History& history, const std::string& name) {
  for (const auto& c : history.columns)
    if (c.name == name) return &c.values;
  return nullptr;
}

Numbers curve_of(const packing::SizeCurve& curve, NumberBlock& block) {
  return {{"diameter", block.add_reals(curve.diameter)}, {"passing", block.add_coarse(curve.passing)}};
}

}  // namespace

double shear_rate_at(const StageResult& stage, double time) {
  const auto *strain = column(stage.history, "shear_strain"), *times = column(stage.history, "time");
  if (!strain || !times || times->size() < 2) return 0;
  const auto after = std::clamp<std::ptrdiff_t>(std::ranges::lower_bound(*times, time) - times->begin(), 1, static_cast<std::ptrdiff_t>(times->size()) - 1);
  const auto k = static_cast<std::size_t>(after);
  const double span = (*times)[k] - (*times)[k - 1];
  return span > 0 ? ((*strain)[k] - (*strain)[k - 1]) / span : 0;
}

Numbers coarse_fields_of(const Packing& packing, double shear_rate, NumberBlock& block) {
  if (packing.grains.size() == 0 || !(packing.domain.width() > 0) || !(packing.domain.height() > 0) || !(packing.domain.thickness > 0)) return {};
  const double diameter = mean_diameter(packing.grains), spacing = std::max(diameter, std::sqrt(packing.domain.area() / most_cells));
  fields::CoarseGraining choice;
  choice.width = spacing;
  if (shear_rate != 0) choice.tilt_rate = shear_rate * packing.domain.height();
  const auto f = fields::coarse_grain(packing, fields::grid_over(packing.domain, spacing), choice);
  std::vector<double> vx, vy, pressure, deviator, shear, kinetic;
  for (std::size_t k = 0; k < f.grid.size(); ++k) {
    const Tensor2 c = f.contact_stress[k], t = f.kinetic_stress[k];
    vx.push_back(f.velocity[k].x);
    vy.push_back(f.velocity[k].y);
    pressure.push_back(-0.5 * (trace(c) + trace(t)));
    deviator.push_back(0.5 * std::hypot(c.xx + t.xx - c.yy - t.yy, c.xy + c.yx + t.xy + t.yx));
    shear.push_back(0.5 * (c.xy + c.yx + t.xy + t.yx));
    kinetic.push_back(-0.5 * trace(t));
  }
  const auto& b = f.grid.bounds;
  Numbers out{{"bounds", {b.x_min, b.x_max, b.y_min, b.y_max}}, {"columns", f.grid.columns}, {"rows", f.grid.rows}, {"width", choice.width}};
  out["solid_fraction"] = block.add_coarse(f.solid_fraction);
  out["density"] = block.add_coarse(f.density);
  out["pressure"] = block.add_coarse(pressure);
  out["deviator"] = block.add_coarse(deviator);
  out["shear"] = block.add_coarse(shear);
  if (std::ranges::all_of(kinetic, [](double v) { return v == 0; })) return out;
  out["vx"] = block.add_coarse(vx);
  out["vy"] = block.add_coarse(vy);
  out["kinetic"] = block.add_coarse(kinetic);
  return out;
}

Numbers size_curves_of(const Packing& packing, const std::string& recipe, NumberBlock& block) {
  try {
    const recipe::Recipe asked = recipe::parse_recipe(recipe, "recipe");
    if (asked.populations.empty()) return {};
    return {{"measured", curve_of(packing::measured_size_curve(packing.grains, packing.materials), block)},
            {"asked", curve_of(packing::asked_size_curve(asked.populations, asked.materials, asked.packing.grains), block)}};
  } catch (const InputError&) {
    return {};  // a packing that no recipe made
  }
}

}  // namespace arenite::report
