#include "grains/fields/laboratory/curves_in_space.hpp"

#include <utility>
#include <vector>

#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "grains/fields/laboratory/shear_in_space.hpp"
#include "grains/fields/laboratory/tested_stage.hpp"
#include "grains/fields/laboratory/triaxial.hpp"
#include "grains/fields/loading.hpp"

namespace arenite::fields {

std::optional<statistics::Columns> curves_in_space(const SphereResult& result, int axis) {
  if (!has_history(result)) return {};
  const std::vector<double>& time = *result.history.find("time");
  auto of_test = triaxial_curves(result, axis);
  if (!of_test) of_test = shear_columns(result);
  if (!of_test) return {};
  statistics::Columns curves;
  curves.put("time", "s", "Time since the first row", mapped(time, [&](double t) { return t - time.front(); }));
  for (auto& curve : of_test->list) curves.list.push_back(std::move(curve));
  for (auto& energy : energies_of(result.history).list) curves.list.push_back(std::move(energy));
  return curves;
}

statistics::Columns curves_in_space(const SphereResult& result) {
  auto curves = curves_in_space(result, result.asked.closes);
  if (!curves)
    throw refusal("the stage {} of spheres is neither compressed along one axis nor sheared; it has no curves",
                  result.name);
  return std::move(*curves);
}

}  // namespace arenite::fields
