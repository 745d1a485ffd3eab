#include "grains/fields/laboratory/triaxial.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "grains/fields/laboratory/box_in_space.hpp"
#include "grains/fields/loading.hpp"

namespace arenite::fields {
namespace {

using Values = std::vector<double>;

}  // namespace

int closing_axis(const dem::Stage& stage) {
  int axis = -1;
  for (int side = 0; side < sides_in<3>; ++side) {
    if (!dem::moves_side(stage, side)) continue;
    if (axis >= 0 && axis != axis_of(side)) return -1;
    axis = axis_of(side);
  }
  return axis;
}

std::optional<statistics::Columns> triaxial_curves(const SphereResult& result, int axis) {
  const Values* time = result.history.find("time");
  const auto box = box_in_space(result);
  if (axis < 0 || !box || result.snapshots.empty()) return {};
  const PackingIn<3>& packing = result.snapshots.back().packing;
  const std::size_t across[] = {static_cast<std::size_t>(axis + 1) % 3, static_cast<std::size_t>(axis + 2) % 3};
  Values axial, shear, stress, p, q, ratio;
  for (std::size_t k = 0; k < box->rows(); ++k) {
    const double all = box->stress[0][k] + box->stress[1][k] + box->stress[2][k];
    stress.push_back(box->stress[static_cast<std::size_t>(axis)][k]);
    p.push_back(all / 3);
    q.push_back(1.5 * stress[k] - 0.5 * all);
    ratio.push_back(p[k] > 0 ? q[k] / p[k] : statistics::unknown);
    const auto wider = [&](std::size_t a) { return box->size[a][k] / box->before[a] - 1; };
    axial.push_back(-wider(static_cast<std::size_t>(axis)));
    shear.push_back(axial[k] + 0.5 * (wider(across[0]) + wider(across[1])));
  }
  statistics::Columns curves;
  curves.put("axial_strain", "", "Strain along the axis that closes, compression positive", axial);
  curves.put("volumetric_strain", "", "Volumetric strain, compaction positive", box->volumetric_strain());
  curves.put("axial_stress", "Pa", "Mean normal stress on the two sides that close", stress);
  curves.put("p", "Pa", "Mean of the three normal stresses on the sides", p);
  curves.put("q", "Pa", "Axial stress less the mean of the two others", q);
  curves.put("q_over_p", "", "Stress ratio from the forces on the sides", ratio);
  curves.put("solid_fraction", "", "Volume of grains over that of the box",
             box->solid_fraction(packing.grains.volume()));
  if (time && time->size() > 1 && is_confined(curves))
    curves.put("inertial_number", "",
               "Rate of the axial strain less the mean of the others, times mean diameter over sqrt(p/density)",
               inertial_numbers(shear, *time, p, packing));
  return curves;
}

bool is_confined(const statistics::Columns& curves) {
  const Values &p = curves["p"], &axial = curves["axial_stress"];
  const double most = *std::ranges::max_element(axial);
  for (std::size_t k = 0; k < p.size(); ++k)
    if (3 * p[k] - axial[k] > 1e-3 * most) return true;
  return false;
}

}  // namespace arenite::fields
