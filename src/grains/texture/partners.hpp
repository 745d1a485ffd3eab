#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/packing.hpp"
#include "statistics/jackknife.hpp"

namespace arenite::texture {

/// Contacts with other grains of every disk or sphere, by the partner's material. Where `rattler` is empty there is
/// none.
struct Partners {
  template <int D>
  explicit Partners(const PackingIn<D>& packing, const std::vector<std::uint8_t>& rattler = {})
      : kinds(packing.materials.size()) {
    const auto material = [&](std::size_t grain) { return static_cast<std::size_t>(packing.grains.material[grain]); };
    for (std::size_t g = 0; g < packing.grains.size(); ++g) kinds = std::max(kinds, material(g) + 1);
    count.assign(packing.grains.size() * kinds, 0);
    bearing.assign(packing.grains.size(), 0);
    const ContactsIn<D>& contacts = packing.contacts;
    for (std::size_t c = 0; c < contacts.size(); ++c) {
      if (contacts.is_wall(c)) continue;
      const auto i = static_cast<std::size_t>(contacts.i[c]), j = static_cast<std::size_t>(contacts.j[c]);
      ++count[i * kinds + material(j)];
      ++count[j * kinds + material(i)];
      if (!rattler.empty() && (rattler[i] || rattler[j])) continue;
      ++bearing[i];
      ++bearing[j];
    }
  }
  double with(std::size_t grain, int m) const { return count[grain * kinds + static_cast<std::size_t>(m)]; }
  double all(std::size_t grain) const {
    double sum = 0;
    for (std::size_t m = 0; m < kinds; ++m) sum += count[grain * kinds + m];
    return sum;
  }
  std::vector<std::int32_t> of_each() const {
    std::vector<std::int32_t> each;
    for (std::size_t g = 0; g < bearing.size(); ++g) each.push_back(static_cast<std::int32_t>(all(g)));
    return each;
  }
  /// Share of some grains that have 0, 1, 2, .. contacts.
  std::vector<double> histogram(const statistics::Items& grains) const {
    std::vector<double> share;
    for (const std::size_t g : grains) {
      const auto k = static_cast<std::size_t>(all(g));
      if (share.size() <= k) share.resize(k + 1, 0.0);
      share[k] += 1.0 / static_cast<double>(grains.size());
    }
    return share;
  }

  std::size_t kinds;
  std::vector<int> count;    ///< [grain * kinds + material]
  std::vector<int> bearing;  ///< contacts that remain without rattlers
};

/// Ratio of two sums over the considered grains.
template <class AnyView, class Top, class Under>
statistics::Estimate ratio_of_sums(const AnyView& view, Top top, Under under) {
  const auto add = [&](std::size_t g, double* sums) {
    sums[0] += top(g);
    sums[1] += under(g);
  };
  const auto quotient = [](const std::vector<double>& s) {
    return std::vector<double>{s[1] > 0 ? s[0] / s[1] : statistics::unknown};
  };
  return statistics::jackknife_of_sums(view.grains, view.grain_block, 2, add, quotient)[0];
}

/// Mean number of contacts that remain without rattlers, of grains that are none.
template <class AnyView> statistics::Estimate mean_without_rattlers(const AnyView& view, const Partners& partners) {
  const auto bears = [&](std::size_t g) { return view.rattler[g] ? 0.0 : 1.0; };
  return ratio_of_sums(
      view, [&](std::size_t g) { return bears(g) * partners.bearing[g]; }, bears);
}

}  // namespace arenite::texture
