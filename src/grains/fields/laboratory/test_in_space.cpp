#include "grains/fields/laboratory/test_in_space.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/mapped.hpp"
#include "grains/fields/laboratory/shear_in_space.hpp"
#include "grains/fields/laboratory/triaxial.hpp"

namespace arenite::fields {
namespace {

using Values = std::vector<double>;

Values sizes(const Values& values) {
  return mapped(values, [](double v) { return std::abs(v); });
}

}  // namespace

std::optional<TestCurves> test_curves(const SphereResult& stage) {
  const int axis = stage.asked.closes;
  const auto columns = axis >= 0 ? triaxial_curves(stage, axis) : shear_columns(stage);
  if (!columns || (*columns)["solid_fraction"].size() < 3) return {};
  TestCurves curves;
  curves.sheared = columns->has("mu");
  curves.confined = curves.sheared || is_confined(*columns);
  curves.strain_name = curves.sheared ? "shear strain" : "axial strain";
  curves.strain = (*columns)[curves.sheared ? "shear_strain" : "axial_strain"];
  curves.ratio = (*columns)[curves.ratio_name()];
  if (curves.confined) {
    curves.strain = sizes(curves.strain), curves.ratio = sizes(curves.ratio);
    curves.shear = (*columns)[curves.sheared ? "tau" : "q"];
    curves.normal = (*columns)[curves.sheared ? "normal_stress" : "p"];
    if (!(std::ranges::max(curves.normal) > 0)) return {};
  }
  if (std::ranges::max(sizes(curves.strain)) < strain_of_a_test) return {};
  curves.volume = (*columns)["volumetric_strain"];
  curves.solid_fraction = (*columns)["solid_fraction"];
  if (const auto* inertial = columns->find("inertial_number")) curves.inertial_number = inertial->values;
  return curves;
}

}  // namespace arenite::fields
