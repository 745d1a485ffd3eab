#include "grains/texture/stress.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/ball.hpp"
#include "grains/texture/distribution.hpp"
#include "grains/texture/spheres/tensor3.hpp"
#include "grains/texture/view.hpp"
#include "model/joints.hpp"

namespace arenite::texture {
namespace {

double length_of(const Domain& domain) { return domain.thickness; }
double length_of(const DomainIn<3>& /*domain*/) { return 1; }

/// What a laboratory could not measure is NaN, and no part of the mean.
template <int D> void take_measured(const ViewIn<D>& view, PerGrainIn<D>& rows) {
  rows.sigma_hyd = view.options.grain_sigma_hyd;
  const double mean = mean_of_known(view.grains, rows.sigma_hyd);
  for (const double value : rows.sigma_hyd) rows.sigma_norm.push_back(mean != 0 ? value / mean : 0);
}

/// By the internal moment of a grain.
template <int D> Tensor<D> stress_of(const PackingIn<D>& packing, std::size_t grain, const Tensor<D>& moment) {
  return 1 / (geometry::volume_of_ball<D>(packing.grains.radius[grain]) * length_of(packing.domain)) * moment;
}

}  // namespace

template <int D> std::vector<Tensor<D>> grain_moments(const PackingIn<D>& packing) {
  const auto& contacts = packing.contacts;
  std::vector<Tensor<D>> moments(packing.grains.size());
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec<D> f = contacts.force_on_i(c);
    moments[contacts.i[c]] += outer(f, contacts.lever_i(c));
    if (!contacts.is_wall(c)) moments[contacts.j[c]] += outer(-f, contacts.lever_j(c));
  }
  for_each_joint(packing, [&](std::size_t i, std::size_t j, Vec<D> force, Vec<D> branch) {
    const double ri = packing.grains.radius[i], rj = packing.grains.radius[j];
    const Tensor<D> moment = outer(force, -branch);
    moments[i] += ri / (ri + rj) * moment;
    moments[j] += rj / (ri + rj) * moment;
  });
  return moments;
}
template std::vector<Tensor2> grain_moments(const Packing&);
template std::vector<Tensor3> grain_moments(const PackingIn<3>&);

double deviator(const Tensor2& s) { return mohr_radius(s); }

double deviator(const Tensor3& stress) {
  const Vec3 s = spheres::principal(stress).value;
  return std::sqrt(0.5 * ((s.x - s.y) * (s.x - s.y) + (s.y - s.z) * (s.y - s.z) + (s.z - s.x) * (s.z - s.x)));
}

template <int D> std::vector<Tensor<D>> grain_stresses(const PackingIn<D>& packing) {
  std::vector<Tensor<D>> stresses = grain_moments(packing);
  for (std::size_t g = 0; g < stresses.size(); ++g) stresses[g] = stress_of<D>(packing, g, stresses[g]);
  return stresses;
}
template std::vector<Tensor2> grain_stresses(const Packing&);
template std::vector<Tensor3> grain_stresses(const PackingIn<3>&);

/// Stress of every grain over its own volume (T eq. 1.11). The normalised stress needs no length, since it cancels.
template <int D> void grain_stress(const ViewIn<D>& view, TextureIn<D>& texture) {
  if (!view.options.grain_sigma_hyd.empty()) return take_measured(view, texture.per_grain);
  const GrainsIn<D>& grains = view.packing.grains;
  const std::vector<Tensor<D>> moments = grain_moments(view.packing);
  PerGrainIn<D>& rows = texture.per_grain;
  std::vector<double> per_length;  // sigma_hyd times the length, N/m
  double mean = 0;
  for (std::size_t g = 0; g < grains.size(); ++g) {
    per_length.push_back(mean_principal(moments[g]) / geometry::volume_of_ball<D>(grains.radius[g]));
    if (view.considered[g]) mean += per_length[g] / static_cast<double>(view.grains.size());
    if (!view.has_thickness) continue;
    rows.sigma.push_back(stress_of<D>(view.packing, g, moments[g]));
    rows.sigma_hyd.push_back(per_length[g] / length_of(view.packing.domain));
  }
  for (const double value : per_length) rows.sigma_norm.push_back(mean != 0 ? value / mean : 0);
}
template void grain_stress(const View&, Texture&);
template void grain_stress(const SphereView&, TextureIn<3>&);

/// Hydrostatic stress over the mean of the considered grains: of all, of one material, of one zone (T eq. 3.2). Values
/// are kept relative to the mean of all, so that without a length only the mean in Pa is unknown. Grains whose stress
/// is not known are left out.
template <int D> void sigma_norm(const ViewIn<D>& view, TextureIn<D>& texture) {
  const bool measured = !view.options.grain_sigma_hyd.empty();
  if ((view.contacts.empty() && !measured) || view.grains.empty()) return;
  double mean = unknown;  // Pa, tension positive
  if (view.has_thickness || measured) mean = mean_of_known(view.grains, texture.per_grain.sigma_hyd);
  constexpr DistributionNames names{"mean_Pa", "Pa", "P0", "Mean stress of the set's grains",
                                    "Fraction of grains above the set's own mean, P_0"};
  const std::vector<double>& value = texture.per_grain.sigma_norm;
  const Items all = known(view.grains, value);
  for (const auto& [name, set] : grains_by_type(view))
    if (const Items items = known(set, value); !items.empty())
      place_of(name, texture.numbers["sigma_norm"], "by_material")
          .update(distribution(items, all, view.grain_block, value, 1.0, names, mean, view.level()));
  if (!measured && texture.numbers.contains("sigma_norm")) texture.numbers["sigma_norm"].mark(Trait::by_forces);
}
template void sigma_norm(const View&, Texture&);
template void sigma_norm(const SphereView&, TextureIn<3>&);

}  // namespace arenite::texture
