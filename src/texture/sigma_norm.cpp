#include "texture/distribution.hpp"
#include "texture/statistics.hpp"

namespace arenite::texture {

/// Hydrostatic stress over the mean of the considered grains: of all, of one material, of one zone (T eq. 3.2).
/// Values are kept relative to the mean of all, so that without a length only the mean in Pa is unknown.
void measure_sigma_norm(const View& view, Texture& texture) {
  const bool measured = !view.options.grain_sigma_hyd.empty();
  if ((view.contacts.empty() && !measured) || view.grains.empty()) return;
  double mean = unknown;  // Pa, tension positive
  if (view.has_thickness || measured) {
    mean = 0;
    for (const std::size_t g : view.grains) mean += texture.per_grain.sigma_hyd[g] / static_cast<double>(view.grains.size());
  }
  for (const auto& [name, items] : grains_by_type(view))
    if (!items.empty())
      texture.sigma_norm.sets.emplace_back(name, distribution(items, view.grain_block, texture.per_grain.sigma_norm, 1.0, mean));
}

}  // namespace arenite::texture
