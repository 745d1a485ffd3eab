#include "model/field_quantities.hpp"

#include <algorithm>

#include "core/formula.hpp"
#include "core/mapped.hpp"
#include "core/problems.hpp"
#include "core/text.hpp"

namespace arenite {

const std::vector<FieldQuantity>& field_quantities() {
  // Principal stresses are the middle of Mohr's circle and its radius away from it; the first one stands at half the
  // angle that it is turned by.
  static const std::vector<FieldQuantity> list{
      {"yy", "sigma_yy", "\u03c3_{yy}", "Pa", "yy"},
      {"xx", "sigma_xx", "\u03c3_{xx}", "Pa", "xx"},
      {"xy", "sigma_xy", "\u03c3_{xy}", "Pa", "xy"},
      {"hydrostatic", "sigma_hyd", "\u03c3_{hyd}", "Pa", "xx yy + 2 /"},
      {"principal", "sigma_1", "\u03c3_{1}", "Pa", "xx yy + 2 / xx yy - 2 / xy hypot +"},
      {"second", "sigma_2", "\u03c3_{2}", "Pa", "xx yy + 2 / xx yy - 2 / xy hypot -", false},
      {"angle", "sigma_1_angle", "\u03b8_{1}", "deg", "2 xy * xx yy - atan2 90 * pi /", false},
      {"ux", "ux", "u_{x}", "m", "ux"},
      {"uy", "uy", "u_{y}", "m", "uy"},
      {"travel", "u", "|u|", "m", "ux uy hypot", true, true}};
  return list;
}

const FieldQuantity& field_quantity(std::string_view name) {
  const auto& list = field_quantities();
  const auto at = std::ranges::find_if(list, [&](const FieldQuantity& q) { return q.id == name || q.name == name; });
  if (at == list.end())
    throw refusal("a field has no {}; there are {}", name, list_of(mapped(list, &FieldQuantity::name), ", "));
  return *at;
}

bool has(const StressField& field, const FieldQuantity& quantity) {
  const bool of_displacements = quantity.unit == "m";
  return field.size() > 0 && (!of_displacements || field.ux.size() == field.size());
}

std::vector<double> values_of(const FieldQuantity& quantity, const StressField& f) {
  if (!has(f, quantity)) return {};
  return evaluated(quantity.formula, f.size(), [&](std::string_view id) -> std::vector<double> {
    if (id == "xx") return f.xx;
    if (id == "yy") return f.yy;
    if (id == "xy") return f.xy;
    if (id == "ux") return f.ux;
    if (id == "uy") return f.uy;
    return {};
  });
}

std::vector<double> values_of(const FieldQuantity& quantity, const std::vector<Tensor2>& stresses) {
  return evaluated(quantity.formula, stresses.size(), [&](std::string_view id) -> std::vector<double> {
    if (id == "xx") return mapped(stresses, &Tensor2::xx);
    if (id == "yy") return mapped(stresses, &Tensor2::yy);
    if (id == "xy") return mapped(stresses, &Tensor2::xy);
    return {};
  });
}

}  // namespace arenite
