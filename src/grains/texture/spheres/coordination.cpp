#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "grains/texture/spheres/sphere_view.hpp"

namespace arenite::texture::spheres {

using statistics::Estimate;
using statistics::Items;
using statistics::put;

namespace {

/// Contacts with other spheres of each, by the partner's material; and those that remain without rattlers.
struct SpherePartners {
  std::size_t kinds = 1;
  std::vector<double> with, bearing;  ///< with: [sphere * kinds + material]

  explicit SpherePartners(const SphereView& view) {
    const GrainsIn<3>& grains = view.packing.grains;
    for (const std::int32_t m : grains.material) kinds = std::max(kinds, static_cast<std::size_t>(m) + 1);
    with.assign(grains.size() * kinds, 0);
    bearing.assign(grains.size(), 0);
    for (std::size_t c = 0; c < view.pairs().size(); ++c) {
      if (view.pairs().is_wall(c)) continue;
      const auto i = static_cast<std::size_t>(view.pairs().i[c]), j = static_cast<std::size_t>(view.pairs().j[c]);
      ++with[i * kinds + static_cast<std::size_t>(grains.material[j])];
      ++with[j * kinds + static_cast<std::size_t>(grains.material[i])];
      if (view.rattler[i] || view.rattler[j]) continue;
      ++bearing[i], ++bearing[j];
    }
  }
  double all(std::size_t g) const {
    double sum = 0;
    for (std::size_t m = 0; m < kinds; ++m) sum += with[g * kinds + m];
    return sum;
  }
};

Estimate mean_without_rattlers(const SphereView& view, const SpherePartners& partners) {
  const auto add = [&](std::size_t g, double* sums) {
    if (view.rattler[g]) return;
    sums[0] += partners.bearing[g];
    sums[1] += 1;
  };
  return statistics::jackknife_of_sums(view.grains, view.grain_block, 2, add, [](const std::vector<double>& s) {
    return std::vector<double>{s[1] > 0 ? s[0] / s[1] : statistics::unknown};
  })[0];
}

}  // namespace

SphereStatistic sphere_coordination;

/// As of disks: contacts with walls are not counted.
void sphere_coordination(const SphereView& view, Numbers& to) {
  constexpr const char* mean_number = "Mean number of contacts per grain, of the named pair or set";
  const SpherePartners partners(view);
  Numbers& j = to["coordination"] = Numbers::tree();
  if (view.grains.empty()) return;
  const auto mean_of = [&](const Items& items, auto value) { return statistics::mean(items, view.grain_block, value); };
  put(j, "all", mean_of(view.grains, [&](std::size_t g) { return partners.all(g); }), "", mean_number);
  put(j, "without_rattlers", mean_without_rattlers(view, partners), "", mean_number, Trait::by_forces);
  for (const int x : view.materials())
    for (const int y : view.materials())
      put(j, view.material_name(x) + "-" + view.material_name(y),
          mean_of(view.grains_of(x),
                  [&](std::size_t g) { return partners.with[g * partners.kinds + static_cast<std::size_t>(y)]; }),
          "", mean_number);
  const std::string sentence =
      "Fraction of grains with fewer than " + std::to_string(view.options.rattler_contacts) + " force-bearing contacts";
  put(j, "rattlers", mean_of(view.grains, [&](std::size_t g) { return view.rattler[g] ? 1.0 : 0.0; }), "",
      sentence.c_str(), Trait::by_forces);
  std::vector<double> histogram;
  for (const std::size_t g : view.grains) {
    const auto k = static_cast<std::size_t>(partners.all(g));
    if (histogram.size() <= k) histogram.resize(k + 1, 0.0);
    histogram[k] += 1.0 / static_cast<double>(view.grains.size());
  }
  put(j, "histogram", histogram, "", "Fraction of grains with 0, 1, 2, .. contacts", Trait::detail);
}

}  // namespace arenite::texture::spheres
