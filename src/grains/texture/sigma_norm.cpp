#include "grains/texture/distribution.hpp"
#include "grains/texture/statistics.hpp"

namespace arenite::texture {

/// Hydrostatic stress over the mean of the considered grains: of all, of one material, of one zone (T eq. 3.2).
/// Values are kept relative to the mean of all, so that without a length only the mean in Pa is unknown. Grains whose stress is
/// not known are left out.
void measure_sigma_norm(const View& view, Texture& texture) {
  const bool measured = !view.options.grain_sigma_hyd.empty();
  if ((view.contacts.empty() && !measured) || view.grains.empty()) return;
  double mean = unknown;  // Pa, tension positive
  if (view.has_thickness || measured) mean = mean_of_known(view.grains, texture.per_grain.sigma_hyd);
  for (const auto& [name, all] : grains_by_type(view))
    if (const Items items = known(all, texture.per_grain.sigma_norm); !items.empty())
      texture.sigma_norm.sets.emplace_back(name, distribution(items, view.grain_block, texture.per_grain.sigma_norm, 1.0, mean));
}

}  // namespace arenite::texture
