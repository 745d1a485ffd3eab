#include <complex>
#include <vector>

#include "grains/texture/view.hpp"

namespace arenite::texture {
namespace {

/// exp(6 i theta) summed over the contacts of every grain, and their number.
struct Six {
  std::vector<std::complex<double>> sum;
  std::vector<int> count;

  template <class Keep>
  Six(const View& view, Keep keep) : sum(view.packing.grains.size()),
                                     count(view.packing.grains.size(), 0) {
    for (std::size_t c = 0; c < view.pairs().size(); ++c) {
      if (view.pairs().is_wall(c)) continue;
      const auto i = static_cast<std::size_t>(view.pairs().i[c]), j = static_cast<std::size_t>(view.pairs().j[c]);
      if (!keep(i, j)) continue;
      const std::complex<double> n{view.pairs().normal[c].x, view.pairs().normal[c].y}, n2 = n * n, n6 = n2 * n2 * n2;
      for (const std::size_t g : {i, j}) {
        sum[g] += n6;
        ++count[g];
      }
    }
  }
  double psi(std::size_t g) const { return count[g] > 0 ? std::abs(sum[g]) / count[g] : 0; }
};

}  // namespace

/// psi_6 over contacts, and the share of grains that stand in a triangular lattice of their own material (T 4.3).
void local_order(const View& view, Texture& texture) {
  const Six any(view, [](std::size_t, std::size_t) { return true; });
  for (std::size_t g = 0; g < view.packing.grains.size(); ++g) texture.per_grain.psi6.push_back(any.psi(g));
  const Items touching = kept(view.grains, [&](std::size_t g) { return any.count[g] > 0; });
  const Six like(view, [&](std::size_t i, std::size_t j) { return view.material(i) == view.material(j); });
  const auto stands_in_lattice = [&](std::size_t g) { return like.count[g] >= 5 && like.psi(g) > 0.9 ? 1.0 : 0.0; };
  ByName<Estimate> ordered;
  for (const int m : view.materials())
    ordered.emplace_back(view.material_name(m), mean(view.grains_of(m), view.grain_block, stands_in_lattice));

  Numbers& j = texture.numbers["local_order"] = Numbers::tree();
  put(j, "psi6", mean(touching, view.grain_block, [&](std::size_t g) { return any.psi(g); }), "",
      "Mean |<exp(6 i theta)>| over a grain's contacts");
  put(j, "triangular_share", ordered, "",
      "Fraction of grains with five or more like neighbours and psi_6 of these above 0.9", Trait::detail);
}

}  // namespace arenite::texture
