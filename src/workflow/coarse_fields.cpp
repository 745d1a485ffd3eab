#include "workflow/coarse_fields.hpp"

#include <algorithm>
#include <numeric>

#include "core/error.hpp"

namespace arenite::workflow {
namespace {

const std::vector<double>* column(const History& history, const std::string& name) {
  for (const auto& c : history.columns)
    if (c.name == name) return &c.values;
  return nullptr;
}

}  // namespace

double shear_rate_at(const History& history, double time) {
  const auto *strain = column(history, "shear_strain"), *times = column(history, "time");
  if (!strain || !times || times->size() < 2) return 0;
  const auto after = std::clamp<std::ptrdiff_t>(std::ranges::lower_bound(*times, time) - times->begin(), 1, static_cast<std::ptrdiff_t>(times->size()) - 1);
  const auto k = static_cast<std::size_t>(after);
  const double span = (*times)[k] - (*times)[k - 1];
  return span > 0 ? ((*strain)[k] - (*strain)[k - 1]) / span : 0;
}

double mean_diameter(const Grains& grains) {
  const double sum = std::accumulate(grains.radius.begin(), grains.radius.end(), 0.0);
  return grains.size() == 0 ? 0 : 2 * sum / static_cast<double>(grains.size());
}

bool has_fields(const Packing& packing) {
  return packing.grains.size() > 0 && packing.domain.width() > 0 && packing.domain.height() > 0 && packing.domain.thickness > 0;
}

fields::CoarseFields coarse_fields(const Packing& packing, double shear_rate, double width, double spacing) {
  fields::CoarseGraining choice;
  choice.width = width;
  if (shear_rate != 0) choice.tilt_rate = shear_rate * packing.domain.height();
  return fields::coarse_grain(packing, fields::grid_over(packing.domain, spacing), choice);
}

io::GridFields grid_fields(const Packing& packing, double shear_rate) {
  if (!has_fields(packing)) throw InputError("this result has no box of known thickness, which coarse-grained fields need");
  const double width = mean_diameter(packing.grains);
  const auto f = coarse_fields(packing, shear_rate, width, 0.5 * width);
  io::GridFields g{f.grid.bounds.x_min, f.grid.bounds.y_min, f.grid.bounds.width() / f.grid.columns, f.grid.bounds.height() / f.grid.rows,
                   f.grid.columns,      f.grid.rows};
  g.scalars = {{"solid_fraction", "1", f.solid_fraction}, {"density", "kg/m^3", f.density}};
  io::GrainField kinetic{"kinetic_pressure", "Pa", {}};
  for (std::size_t k = 0; k < f.grid.size(); ++k) {
    const Tensor2 c = f.contact_stress[k], t = f.kinetic_stress[k];
    g.vx.push_back(f.velocity[k].x), g.vy.push_back(f.velocity[k].y);
    g.stress_xx.push_back(c.xx + t.xx), g.stress_yy.push_back(c.yy + t.yy), g.stress_xy.push_back(0.5 * (c.xy + c.yx + t.xy + t.yx));
    kinetic.values.push_back(-0.5 * trace(t));
  }
  g.scalars.push_back(std::move(kinetic));
  return g;
}

}  // namespace arenite::workflow
