#include "grains/fields/coarse_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

#include "core/formula.hpp"
#include "core/mapped.hpp"
#include "grains/texture/stress.hpp"

namespace arenite::fields {
namespace {

using texture::deviator;
using texture::pressure;

using Values = std::vector<double>;

double shear_of(const Tensor2& s, int /*a*/, int /*b*/) { return 0.5 * (s.xy + s.yx); }
double shear_of(const Tensor3& s, int a, int b) { return 0.5 * (s.at[a][b] + s.at[b][a]); }

/// `of(stress)` at every point.
template <int D, class Of> Values of_stress(const CoarseFieldsIn<D>& f, Of of) {
  Values values;
  for (std::size_t k = 0; k < f.grid.size(); ++k) values.push_back(of(f.stress(k)));
  return values;
}

struct Words {
  std::string_view name, label, symbol;
};
constexpr std::array<Words, 3> velocities{
    {{"vx", "Velocity along x", "v_{x}"}, {"vy", "Velocity along y", "v_{y}"}, {"vz", "Velocity along z", "v_{z}"}}};
constexpr std::array speeds{"vx vy hypot", "vx vy hypot vz hypot"};

/// On planes across one axis and along another.
struct Shear {
  Words words;
  int a, b;
};
const std::vector<Shear>& shears_of(const Packing* /*of*/) {
  static const std::vector<Shear> shears{{{"shear", "Shear stress", "\u03c3_{xy}"}, 0, 1}};
  return shears;
}
const std::vector<Shear>& shears_of(const PackingIn<3>* /*of*/) {
  static const std::vector<Shear> shears{{{"shear", "Shear stress xy", "\u03c3_{xy}"}, 0, 1},
                                         {{"shear_yz", "Shear stress yz", "\u03c3_{yz}"}, 1, 2},
                                         {{"shear_xz", "Shear stress xz", "\u03c3_{xz}"}, 0, 2}};
  return shears;
}

template <int D> std::vector<CoarseLayerIn<D>> layers_in() {
  using enum ColourScale;
  using Fields = CoarseFieldsIn<D>;
  const auto whole = [](auto of) { return [of](const Fields& f) { return of_stress<D>(f, of); }; };
  std::vector<CoarseLayerIn<D>> list{
      {"solid_fraction",
       "Solid fraction",
       "\u03c6",
       "",
       even,
       false,
       [](const Fields& f) { return f.solid_fraction; },
       {},
       true},
      {"density", "Density", "\u03c1", "kg/m^3", even, false, [](const Fields& f) { return f.density; }, {}, true},
      {"speed", "Velocity", "|v|", "m/s", even, true, nullptr, speeds[D - 2]}};
  for (int axis = 0; axis < D; ++axis) {
    const auto& [name, label, symbol] = velocities[static_cast<std::size_t>(axis)];
    list.push_back({name, label, symbol, "m/s", diverging, true, [axis](const Fields& f) {
                      return mapped(f.velocity, [axis](const Vec<D>& v) { return v[axis]; });
                    }});
  }
  list.push_back(
      {"pressure", "Pressure", "p", "Pa", stress, false, whole([](const Tensor<D>& s) { return pressure(s); })});
  list.push_back({"deviator", "Deviator of stress", "q", "Pa", stress, false,
                  whole([](const Tensor<D>& s) { return deviator(s); })});
  for (const auto& [words, a, b] : shears_of(static_cast<const PackingIn<D>*>(nullptr)))
    list.push_back({words.name, words.label, words.symbol, "Pa", diverging, false,
                    whole([a = a, b = b](const Tensor<D>& s) { return shear_of(s, a, b); })});
  list.push_back({"kinetic", "Kinetic pressure", "p_{kin}", "Pa", stress, true, [](const Fields& f) {
                    return mapped(f.kinetic_stress, [](const Tensor<D>& s) { return pressure(s); });
                  }});
  return list;
}

bool are_in_motion(const auto& fields) {
  return std::ranges::any_of(fields.kinetic_stress, [](const auto& t) { return trace(t) != 0; });
}

double spacing_to_show(const Packing& packing) {
  constexpr double most_cells = 2500;
  return std::max(packing.grains.mean_diameter(), std::sqrt(packing.domain.area() / most_cells));
}

double spacing_to_show(const PackingIn<3>& packing) {
  constexpr double most_cells = 48;  // along the longest side
  const Vec3 size = packing.domain.size();
  return std::max(0.5 * packing.grains.mean_diameter(), std::max({size.x, size.y, size.z}) / most_cells);
}

}  // namespace

template <int D> const std::vector<CoarseLayerIn<D>>& coarse_layers() {
  static const std::vector<CoarseLayerIn<D>> list = layers_in<D>();
  return list;
}

template <int D> bool has_layer(const CoarseLayerIn<D>& layer, const CoarseFieldsIn<D>& fields) {
  return !layer.is_of_motion || are_in_motion(fields);
}

template <int D> std::vector<double> values_of(const CoarseLayerIn<D>& layer, const CoarseFieldsIn<D>& fields) {
  if (layer.formula.empty()) return layer.of(fields);
  return evaluated(layer.formula, fields.grid.size(), [&](std::string_view name) {
    return std::ranges::find(coarse_layers<D>(), name, &CoarseLayerIn<D>::name)->of(fields);
  });
}

template <int D> GridIn<D> grid_to_show(const PackingIn<D>& packing) {
  return grid_over<D>(packing.domain, spacing_to_show(packing));
}

template <int D> double width_to_show(const PackingIn<D>& packing, const GridIn<D>& grid) {
  double width = packing.grains.mean_diameter();
  for (int axis = 0; axis < D; ++axis) width = std::max(width, grid.step()[axis]);
  return width;
}

template <int D>
CoarseFieldsIn<D> fields_to_show(const PackingIn<D>& packing, double shear_rate, const GridIn<D>& grid) {
  return coarse_fields(packing, shear_rate, width_to_show(packing, grid), grid);
}

#define ARENITE_OF(D)                                                                        \
  template const std::vector<CoarseLayerIn<D>>& coarse_layers<D>();                          \
  template bool has_layer(const CoarseLayerIn<D>&, const CoarseFieldsIn<D>&);                \
  template std::vector<double> values_of(const CoarseLayerIn<D>&, const CoarseFieldsIn<D>&); \
  template GridIn<D> grid_to_show(const PackingIn<D>&);                                      \
  template double width_to_show(const PackingIn<D>&, const GridIn<D>&);                      \
  template CoarseFieldsIn<D> fields_to_show(const PackingIn<D>&, double, const GridIn<D>&);
ARENITE_OF(2)
ARENITE_OF(3)
#undef ARENITE_OF

}  // namespace arenite::fields
