#include "grains/fields/state_fields.hpp"

#include <algorithm>
#include <numeric>

namespace arenite::fields {
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

CoarseFields coarse_fields(const Packing& packing, double shear_rate, double width, double spacing) {
  CoarseGraining choice;
  choice.width = width;
  if (shear_rate != 0) choice.tilt_rate = shear_rate * packing.domain.height();
  return coarse_grain(packing, grid_over(packing.domain, spacing), choice);
}

}  // namespace arenite::fields
