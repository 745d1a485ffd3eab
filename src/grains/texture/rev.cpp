#include "grains/texture/rev.hpp"

#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "geometry/ball.hpp"
#include "grains/texture/view.hpp"

namespace arenite::texture {
namespace {

/// Solid fractions of windows of the box's shape, `side` of its side long, at random places in the whole box: those
/// across a periodic side, too, so that each part of the sample is seen as often.
template <int D>
std::vector<double> fractions(const PackingIn<D>& packing, double side, int places, RandomStream random) {
  const DomainIn<D>& domain = packing.domain;
  const GrainsIn<D>& grains = packing.grains;
  const Vec<D> low = domain.corner(), high = domain.corner(1), size = side * domain.size();
  std::vector<double> found;
  for (int p = 0; p < places; ++p) {
    Vec<D> corner;
    for (int axis = 0; axis < D; ++axis)
      corner[axis] = random.uniform(low[axis], domain.periodic[axis] ? high[axis] : high[axis] - size[axis]);
    const Region<D> window = region_from(corner, size);
    double covered = 0;
    for (std::size_t g = 0; g < grains.size(); ++g)
      covered += covered_by<D>(domain, grains.position[g], grains.radius[g], window);
    found.push_back(covered / volume_of(window));
  }
  return found;
}

const char* name_of_share(const Domain& /*domain*/) { return "area_share"; }
const char* name_of_share(const DomainIn<3>& /*domain*/) { return "volume_share"; }

}  // namespace

template <int D> void rev(const ViewIn<D>& view, TextureIn<D>& texture) {
  const auto [sizes, places] = view.options.rev;
  if (!view.has_box || view.packing.grains.size() == 0 || sizes == 0) return;
  Rev& r = texture.rev;
  for (int s = 0; s < sizes; ++s) {
    const double side = 0.05 + (0.98 - 0.05) * (sizes > 1 ? static_cast<double>(s) / (sizes - 1) : 1);
    double sum = 0, squares = 0, share = 1;
    for (const double fraction :
         fractions(view.packing, side, places,
                   RandomStream(view.options.seed, Purpose::window, static_cast<std::uint64_t>(s)))) {
      sum += fraction;
      squares += fraction * fraction;
    }
    const double mean = sum / places;
    const double deviation =
        places > 1 ? std::sqrt(std::max(0.0, (squares - places * mean * mean) / (places - 1))) : unknown;
    for (int axis = 0; axis < D; ++axis) share *= side;
    r.share.push_back(share);
    r.mean.push_back(mean);
    r.deviation.push_back(deviation);
    r.error.push_back(std::hypot(deviation / std::sqrt(static_cast<double>(places)), texture.solid_fraction.error));
  }
  texture.numbers["rev"] = {
      {name_of_share(view.packing.domain), r.share}, {"mean", r.mean}, {"deviation", r.deviation}, {"error", r.error}};
}
template void rev(const View&, Texture&);
template void rev(const SphereView&, TextureIn<3>&);

std::vector<double> window_fractions(const Packing& packing, double area_share, int places, std::uint64_t seed) {
  if (packing.grains.size() == 0 || !(packing.domain.area() > 0)) return {};
  return fractions(packing, std::sqrt(area_share), places, RandomStream(seed, Purpose::window, 0));
}

}  // namespace arenite::texture
