#include "grains/fields/coarse_layers.hpp"

#include <algorithm>
#include <cmath>

#include "core/formula.hpp"
#include "core/mapped.hpp"
#include "grains/texture/stress.hpp"

namespace arenite::fields {
namespace {

using Values = std::vector<double>;

/// `of(stress)` at every point.
template <class Of> Values of_stress(const CoarseFields& f, Of of) {
  Values values;
  for (std::size_t k = 0; k < f.grid.size(); ++k) values.push_back(of(f.stress(k)));
  return values;
}

Values pressures(const CoarseFields& f) { return of_stress(f, texture::pressure); }
Values deviators(const CoarseFields& f) { return of_stress(f, texture::deviator); }
Values shears(const CoarseFields& f) {
  return of_stress(f, [](const Tensor2& s) { return 0.5 * (s.xy + s.yx); });
}
Values kinetic_pressures(const CoarseFields& f) { return mapped(f.kinetic_stress, texture::pressure); }

}  // namespace

const std::vector<CoarseLayer>& coarse_layers() {
  using enum ColourScale;
  static const std::vector<CoarseLayer> list{
      {"solid_fraction", "Solid fraction", "\u03c6", "", even, false,
       [](const CoarseFields& f) { return f.solid_fraction; }},
      {"density", "Density", "\u03c1", "kg/m^3", even, false, [](const CoarseFields& f) { return f.density; }},
      {"speed", "Velocity", "|v|", "m/s", even, true, nullptr, "vx vy hypot"},
      {"vx", "Velocity along x", "v_{x}", "m/s", diverging, true,
       [](const CoarseFields& f) { return mapped(f.velocity, &Vec2::x); }},
      {"vy", "Velocity along y", "v_{y}", "m/s", diverging, true,
       [](const CoarseFields& f) { return mapped(f.velocity, &Vec2::y); }},
      {"pressure", "Pressure", "p", "Pa", stress, false, pressures},
      {"deviator", "Deviator of stress", "q", "Pa", stress, false, deviators},
      {"shear", "Shear stress", "\u03c3_{xy}", "Pa", diverging, false, shears},
      {"kinetic", "Kinetic pressure", "p_{kin}", "Pa", stress, true, kinetic_pressures}};
  return list;
}

std::vector<double> values_of(const CoarseLayer& layer, const CoarseFields& fields) {
  if (layer.formula.empty()) return layer.of(fields);
  return evaluated(layer.formula, fields.grid.size(), [&](std::string_view name) {
    return std::ranges::find(coarse_layers(), name, &CoarseLayer::name)->of(fields);
  });
}

CoarseFields fields_to_show(const Packing& packing, double shear_rate) {
  constexpr double most_cells = 2500;
  const double spacing = std::max(packing.grains.mean_diameter(), std::sqrt(packing.domain.area() / most_cells));
  return coarse_fields(packing, shear_rate, spacing, spacing);
}

bool are_in_motion(const CoarseFields& fields) {
  return std::ranges::any_of(fields.kinetic_stress, [](const Tensor2& t) { return trace(t) != 0; });
}

}  // namespace arenite::fields
