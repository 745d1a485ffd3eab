#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "grains/texture/distribution.hpp"
#include "grains/texture/spheres/sphere_view.hpp"
#include "grains/texture/view.hpp"

namespace arenite::texture::spheres {

using statistics::Items;
using statistics::put;

namespace {

/// Sum over contacts, walls included, bonds and pulls across gaps of f (x) l over the volume of the container, with f
/// on sphere i and l from i to j or to the wall, Pa.
Tensor3 whole_stress(const PackingIn<3>& packing) {
  Tensor3 sum;
  const ContactsIn<3>& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c) sum += outer(contacts.force_on_i(c), contacts.branch(c));
  each_joint(packing, [&](std::size_t, std::size_t, Vec3 force, Vec3 branch) { sum += outer(force, -branch); });
  return (1 / volume_of(packing.domain)) * sum;
}

/// What that must be at rest by the forces on walls and by weight.
Tensor3 stress_from_walls(const PackingIn<3>& packing, Vec3 gravity) {
  Tensor3 sum;
  const ContactsIn<3>& contacts = packing.contacts;
  for (std::size_t c = 0; c < contacts.size(); ++c)
    if (contacts.is_wall(c))
      sum += outer(contacts.force_on_i(c), packing.grains.position[contacts.i[c]] + contacts.lever_i(c));
  if (gravity != Vec3{})
    for (std::size_t g = 0; g < packing.grains.size(); ++g)
      sum += outer(mass_of(packing, g) * gravity, packing.grains.position[g]);
  return (1 / volume_of(packing.domain)) * sum;
}

/// Median |sum F| over spheres with at least four contacts, walls and weight included, over the mean force.
double median_imbalance(const SphereView& view) {
  const ContactsIn<3>& contacts = view.pairs();
  std::vector<Vec3> sum(view.packing.grains.size());
  std::vector<int> count(sum.size(), 0);
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const Vec3 force = contacts.force_on_i(c);
    sum[contacts.i[c]] += force, ++count[contacts.i[c]];
    if (!contacts.is_wall(c)) sum[contacts.j[c]] += -force, ++count[contacts.j[c]];
  }
  each_joint(view.packing, [&](std::size_t i, std::size_t j, Vec3 force, Vec3 /*branch*/) {
    sum[i] += force, ++count[i];
    sum[j] += -force, ++count[j];
  });
  std::vector<double> resultants;
  for (const std::size_t g : view.grains)
    if (count[g] >= 4) resultants.push_back(norm(sum[g] + mass_of(view.packing, g) * view.options.gravity));
  if (resultants.empty() || !(view.mean_force > 0)) return statistics::unknown;
  std::ranges::nth_element(resultants, resultants.begin() + static_cast<std::ptrdiff_t>(resultants.size() / 2));
  return resultants[resultants.size() / 2] / view.mean_force;
}

}  // namespace

SphereStatistic sphere_stress;

void sphere_stress(const SphereView& view, Numbers& to) {
  if (!view.has_box) return;
  const PackingIn<3>& packing = view.packing;
  const Tensor3 stress = whole_stress(packing);
  const Principal axes = principal(stress);
  const Vec3 s = axes.value;
  Numbers details = Numbers::tree();
  put(to, "stress", Numbers{{"value", rows_of(stress)}, {"error", Numbers()}}, "Pa",
      "Mean stress of the sample, tension positive; its error is unknown from one sample", Trait::by_forces);
  put(details, "pressure_Pa", pressure(stress), "Pa",
      "Pressure p, mean of the principal stresses, compression positive");
  put(details, "deviator_Pa", deviator(stress), "Pa",
      "Deviator q, sqrt(3 J_2): in a triaxial test the difference of the principal stresses");
  put(details, "principal_Pa", Numbers::list({s.x, s.y, s.z}), "Pa", "Principal stresses, tension positive");
  const Vec3 n = axes.direction[2];
  put(details, "axis_of_compression", Numbers::list({n.x, n.y, n.z}), "",
      "Direction of greatest compression: x, y, z of a unit vector");
  if (!packing.domain.is_cell())
    put(details, "from_walls_and_weight", rows_of(stress_from_walls(packing, view.options.gravity)), "Pa",
        "Stress from the forces on walls and from weight; the same in equilibrium", Trait::detail);
  to["stress_details"] = details.mark(Trait::by_forces);
}

namespace {

/// Of each sphere, over their mean over those that are measured, Pa, unless that is 0.
struct OverMean {
  std::vector<double> stress;
  double mean = 0;
};

OverMean over_mean(const SphereView& view) {
  OverMean of{hydrostatic_stresses(view.packing)};
  for (const std::size_t g : view.grains) of.mean += of.stress[g] / static_cast<double>(view.grains.size());
  for (double& value : of.stress) value = of.mean == 0 ? 0 : value / of.mean;
  return of;
}

void put_grain_stresses(const SphereView& view, Numbers& to) {
  const auto [hydrostatic, mean] = over_mean(view);
  if (mean == 0) return;
  constexpr DistributionNames names{"mean_Pa", "Pa", "P0", "Mean stress of the set's grains",
                                    "Fraction of grains above the set's own mean, P_0"};
  Numbers& j = to["sigma_norm"] =
      distribution(view.grains, view.grains, view.grain_block, hydrostatic, 1.0, names, mean, 0);
  if (view.materials().size() > 1)
    for (const int m : view.materials())
      j["by_material"][view.material_name(m)] =
          distribution(view.grains_of(m), view.grains, view.grain_block, hydrostatic, 1.0, names, mean, 0);
  j.mark(Trait::by_forces);
}

void put_friction(const SphereView& view, const Items& pushing, Numbers& to) {
  double largest = 0, sum = 0;
  for (const std::size_t c : pushing) {
    const double ratio = norm(view.pairs().ft[c]) / view.pairs().fn[c];
    largest = std::max(largest, ratio);
    sum += ratio;
  }
  put(to, "friction_ratio_max", largest, "", "Largest |F_t|/F_n of compressive contacts", Trait::by_forces);
  put(to, "friction_ratio_mean", sum / static_cast<double>(pushing.size()), "",
      "Mean |F_t|/F_n of compressive contacts", Trait::detail | Trait::by_forces);
}

}  // namespace

SphereStatistic sphere_forces;

/// Distribution of normal forces and of grain stresses, and what tells how well forces are in balance.
void sphere_forces(const SphereView& view, Numbers& to) {
  const Items pushing = kept(view.contacts, [&](std::size_t c) { return view.pairs().fn[c] > 0; });
  if (pushing.empty()) return;
  constexpr DistributionNames names{"mean_N", "N", "strong_share", "Mean force of the set",
                                    "Fraction of the set above its own mean"};
  to["force"] = distribution(pushing, pushing, view.contact_block, view.pairs().fn, view.mean_force, names, 1, 0);
  to["force"].mark(Trait::by_forces);
  put_grain_stresses(view, to);
  Numbers& quality = to["quality"] = Numbers::tree();
  put(quality, "median_imbalance", median_imbalance(view), "",
      "Median |sum F| of grains with at least 4 contacts over the mean force", Trait::by_forces);
  put_friction(view, pushing, quality);
}

}  // namespace arenite::texture::spheres

namespace arenite::texture {

std::vector<double> stresses_over_mean(const PackingIn<3>& packing, const SphereOptions& options) {
  return spheres::over_mean(spheres::SphereView(packing, options)).stress;
}

}  // namespace arenite::texture
