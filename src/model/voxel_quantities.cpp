#include "model/voxel_quantities.hpp"

#include <cmath>

#include "statistics/numbers.hpp"

namespace arenite {
namespace {

double at(const std::vector<float>& values, std::size_t voxel) { return static_cast<double>(values[voxel]); }

double hydrostatic(const VoxelStress& f, std::size_t k) { return (at(f.xx, k) + at(f.yy, k) + at(f.zz, k)) / 3; }

double von_mises(const VoxelStress& f, std::size_t k) {
  const double a = at(f.xx, k) - at(f.yy, k), b = at(f.yy, k) - at(f.zz, k), c = at(f.zz, k) - at(f.xx, k);
  const double yz = at(f.yz, k), xz = at(f.xz, k), xy = at(f.xy, k);
  return std::sqrt((a * a + b * b + c * c) / 2 + 3 * (yz * yz + xz * xz + xy * xy));
}

}  // namespace

const std::vector<VoxelQuantity>& voxel_quantities() {
  static const std::vector<VoxelQuantity> list{
      {"zz", "sigma_zz", "stress along the clamps", "\u03c3_{zz}", "Pa", false,
       [](const VoxelStress& f, std::size_t k) { return at(f.zz, k); }, VoxelQuantity::Acts::along_clamps},
      {"xz", "sigma_xz", "shear stress along the load", "\u03c3_{xz}", "Pa", false,
       [](const VoxelStress& f, std::size_t k) { return at(f.xz, k); }, VoxelQuantity::Acts::shear},
      {"hydrostatic", "sigma_hyd", "mean stress", "\u03c3_{hyd}", "Pa", false, hydrostatic},
      {"mises", "sigma_mises", "von Mises stress", "\u03c3_{vM}", "Pa", true, von_mises},
      {"uz", "u_z", "displacement along the clamps", "u_{z}", "m", false,
       [](const VoxelStress& f, std::size_t k) { return at(f.uz, k); }},
      {"damage", "damage", "share of bonds broken", "D", "", true,
       [](const VoxelStress& f, std::size_t k) { return at(f.damage, k); }, VoxelQuantity::Acts::no_load,
       [](const VoxelStress& f) { return !f.damage.empty(); }}};
  return list;
}

std::vector<const VoxelQuantity*> quantities_of(const VoxelResult& sample) {
  std::vector<const VoxelQuantity*> found;
  for (const VoxelQuantity& q : voxel_quantities())
    if (!q.is_known || q.is_known(sample.field)) found.push_back(&q);
  return found;
}

std::vector<const VoxelQuantity*> quantities_drawn(const VoxelResult& sample) {
  const Numbers* loading = sample.numbers.at_path("/load/loading");
  const bool sheared = loading && *loading == Numbers("shear");
  const auto acts = sheared ? VoxelQuantity::Acts::shear : VoxelQuantity::Acts::along_clamps;
  std::vector<const VoxelQuantity*> drawn;
  for (const VoxelQuantity* q : quantities_of(sample))
    if (q->unit != "m" && (q->by == acts || q->by == VoxelQuantity::Acts::no_load)) drawn.push_back(q);
  return drawn;
}

}  // namespace arenite
