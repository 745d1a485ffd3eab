#include <algorithm>
#include <cmath>

#include "grains/texture/statistics.hpp"

namespace arenite::texture {

/// Signed a_c of the contacts that carry at most, and more than, a multiple of the mean force, from 0 to 4 by 0.1.
void measure_threshold(const View& view, Texture& texture) {
  if (view.contacts.empty() || view.mean_force <= 0) return;
  constexpr std::size_t fewest = 10;
  const auto& contacts = view.pairs();
  Items sorted = view.contacts;
  std::stable_sort(sorted.begin(), sorted.end(), [&](std::size_t a, std::size_t b) { return contacts.fn[a] < contacts.fn[b]; });
  std::vector<double> sum{0};  // of cos 2(theta - theta_load) over the weakest k contacts
  for (const std::size_t c : sorted) {
    const Vec2 n = contacts.normal(c), load{std::cos(view.load_axis), std::sin(view.load_axis)};
    sum.push_back(sum.back() + 2 * dot(n, load) * dot(n, load) - 1);
  }
  ThresholdCurve& curve = texture.threshold;
  const auto push = [](std::vector<double>& a, std::vector<double>& noise, double total, std::size_t n) {
    a.push_back(n < fewest ? unknown : 2 * total / static_cast<double>(n));
    noise.push_back(n < fewest ? unknown : 2 * 0.886 / std::sqrt(static_cast<double>(n)));
  };
  for (int k = 0; k <= 40; ++k) {
    const double threshold = 0.1 * k;
    const auto below = static_cast<std::size_t>(
        std::upper_bound(sorted.begin(), sorted.end(), threshold * view.mean_force,
                         [&](double force, std::size_t c) { return force < contacts.fn[c]; }) - sorted.begin());
    curve.threshold.push_back(threshold);
    push(curve.below, curve.below_noise, sum[below], below);
    push(curve.above, curve.above_noise, sum.back() - sum[below], sorted.size() - below);
  }
}

}  // namespace arenite::texture
