#include "grains/fields/laboratory/shear_in_space.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "grains/fields/laboratory/box_in_space.hpp"
#include "grains/fields/loading.hpp"

namespace arenite::fields {
namespace {

using Values = std::vector<double>;

/// Two sides that go past each other.
struct Sheared {
  int axis = 1;   ///< across them
  Values strain;  ///< row by row
  Values tau;     ///< Pa, positive where the second is held back
};

/// Half of what the first bears along itself less the second, over their area.
Values shear_stress(const History& history, const BoxInSpace& box, int axis) {
  const std::string along = axis == 0 ? "_shear_force_y" : "_shear_force_x";
  const Values *low = column_of_side(history, 2 * axis, along), *high = column_of_side(history, 2 * axis + 1, along);
  Values tau;
  for (std::size_t k = 0; low && high && k < box.rows(); ++k)
    tau.push_back(0.5 * ((*low)[k] - (*high)[k]) / box.area(axis, k));
  return tau;
}

std::optional<Sheared> sheared(const History& history, const BoxInSpace& box) {
  if (const Values* cell = history.find("shear_strain"))
    return Sheared{1, mapped(*cell, [&](double v) { return v - cell->front(); }), shear_stress(history, box, 1)};
  for (const int axis : {1, 2, 0}) {
    Values strain = strain_between(history, history, 2 * axis, 2 * axis + 1, box.size[axis]);
    if (!strain.empty()) return Sheared{axis, std::move(strain), shear_stress(history, box, axis)};
  }
  return {};
}

}  // namespace

std::optional<statistics::Columns> shear_columns(const SphereResult& result) {
  const Values* time = result.history.find("time");
  const auto box = box_in_space(result);
  if (!time || time->size() < 2 || !box || result.snapshots.empty()) return {};
  auto of = sheared(result.history, *box);
  if (!of || of->tau.empty()) return {};
  const Values& normal = box->stress[static_cast<std::size_t>(of->axis)];
  const PackingIn<3>& packing = result.snapshots.back().packing;
  statistics::Columns curves;
  curves.put("shear_strain", "", "Shear strain of the cell, or by the sides that slide, since the first row",
             of->strain);
  curves.put("tau", "Pa", "Shear stress along the sheared sides, positive where the second is held back", of->tau);
  curves.put("normal_stress", "Pa", "Mean normal stress on the sheared sides, compression positive", normal);
  curves.put("mu", "", "Shear over normal stress on the sheared sides", loaded_ratio(of->tau, normal));
  curves.put("volumetric_strain", "", "Volumetric strain, compaction positive", box->volumetric_strain());
  curves.put("solid_fraction", "", "Volume of grains over that of the box",
             box->solid_fraction(packing.grains.volume()));
  curves.put("inertial_number", "", "Rate of shear times mean diameter over sqrt(normal stress/density)",
             inertial_numbers(of->strain, *time, normal, packing));
  return curves;
}

}  // namespace arenite::fields
