#include "solid/elements/stress.hpp"

#include <cstddef>
#include <type_traits>
#include <vector>

#include "core/pages.hpp"
#include "core/vec.hpp"

namespace arenite::elements {
namespace {

/// The strain as what it adds to the amplitudes of each component, [axis][component], of which it has one half each.
template <int D> std::array<Vec<D>, D> amplitudes_of(const Voigt<D>& strain, double dx) {
  std::array<Vec<D>, D> added{};
  const double scale = dx * (1 << (D - 1));
  constexpr auto& axes = voigt_axes<D>;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto [a, b] = axes[k];
    added[static_cast<std::size_t>(a)][b] += scale * strain[k] / (a == b ? 1 : 2);
    if (a != b) added[static_cast<std::size_t>(b)][a] += scale * strain[k] / 2;
  }
  return added;
}

/// The middle of one element.
template <int D> struct Middle {
  Vec<D> displacement;
  Voigt<D> stress;
};

template <int D>
Middle<D> middle_of(const ElementsIn<D>& elements, const FieldIn<D, double>& u, const std::array<Vec<D>, D>& added,
                    double dx, std::array<int, 3> at) {
  Vec<D> sum;
  std::array<Vec<D>, D> g = added;
  for (int c = 0; c < 1 << D; ++c) {
    const Vec<D> corner = u.at(elements.node(at[0] + (c & 1), at[1] + (c >> 1 & 1), at[2] + (c >> 2)));
    sum += corner;
    for (int axis = 0; axis < D; ++axis) g[static_cast<std::size_t>(axis)] += sign_of(1 << axis, c) * corner;
  }
  const Modes<D>& m = elements.modes[elements.kind(elements.grid.index(at[0], at[1], at[2]))];
  const double scale = (1 << (D - 1)) / dx;  // C e, with C the modes times 4^(D-1) and e = g/(2^(D-1) dx)
  Middle<D> middle{sum / (1 << D), {}};
  constexpr auto& axes = voigt_axes<D>;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    const auto [a, b] = axes[k];
    if (a != b) {
      middle.stress[k] = scale * m.shear * (g[static_cast<std::size_t>(b)][a] + g[static_cast<std::size_t>(a)][b]);
      continue;
    }
    double others = 0;
    for (int c = 0; c < D; ++c)
      if (c != a) others += g[static_cast<std::size_t>(c)][c];
    middle.stress[k] = scale * (m.axial * g[static_cast<std::size_t>(a)][a] + m.cross * others);
  }
  return middle;
}

/// The arrays of a field, displacements first, then stresses in Voigt's order.
std::array<std::vector<double>*, 5> arrays_of(StressField& f) { return {&f.ux, &f.uy, &f.xx, &f.yy, &f.xy}; }
std::array<std::vector<float>*, 9> arrays_of(VoxelStress& f) {
  return {&f.ux, &f.uy, &f.uz, &f.xx, &f.yy, &f.zz, &f.yz, &f.xz, &f.xy};
}

void set_size(StressField& field, const PhaseMap& map) {
  field.width = map.width, field.height = map.height, field.dx = map.dx;
}
void set_size(VoxelStress& field, const VoxelMap& map) {
  field.width = map.width, field.height = map.height, field.depth = map.depth, field.dx = map.dx;
}

}  // namespace

template <int D>
StressIn<D> element_stress(const MapIn<D>& map, const ElementsIn<D>& elements, const FieldIn<D, double>& u,
                           const Voigt<D>& strain) {
  StressIn<D> field;
  set_size(field, map);
  const auto arrays = arrays_of(field);
  for (auto* values : arrays) reserve_in_large_pages(*values, map.size()), values->assign(map.size(), 0);
  using Number = typename std::remove_reference_t<decltype(*arrays[0])>::value_type;
  const auto added = amplitudes_of<D>(strain, map.dx);
  elements.each_shared([&](int x, int y, int z) {
    const auto k = static_cast<std::size_t>(elements.place(x, y, z));
    if (map.phase[k] == Phase::empty) return;
    const Middle<D> middle = middle_of<D>(elements, u, added, map.dx, {x, y, z});
    for (int c = 0; c < D; ++c) (*arrays[static_cast<std::size_t>(c)])[k] = static_cast<Number>(middle.displacement[c]);
    for (std::size_t c = 0; c < middle.stress.size(); ++c) (*arrays[D + c])[k] = static_cast<Number>(middle.stress[c]);
  });
  return field;
}

template <int D>
Voigt<D> mean_stress(const ElementsIn<D>& elements, const FieldIn<D, double>& u, const Voigt<D>& strain, double dx) {
  Voigt<D> mean{};
  const auto added = amplitudes_of<D>(strain, dx);
  elements.each([&](int x, int y, int z) {
    if (elements.kind(elements.grid.index(x, y, z)) == none) return;
    const Middle<D> middle = middle_of<D>(elements, u, added, dx, {x, y, z});
    for (std::size_t c = 0; c < mean.size(); ++c) mean[c] += middle.stress[c];
  });
  for (double& component : mean) component /= static_cast<double>(elements.count());
  return mean;
}

template StressField element_stress<2>(const PhaseMap& map, const Elements& elements, const FieldIn<2, double>& u,
                                       const Voigt<2>& strain);
template VoxelStress element_stress<3>(const VoxelMap& map, const Voxels& elements, const FieldIn<3, double>& u,
                                       const Voigt<3>& strain);
template Voigt<2> mean_stress(const Elements& elements, const FieldIn<2, double>& u, const Voigt<2>& strain, double dx);
template Voigt<3> mean_stress(const Voxels& elements, const FieldIn<3, double>& u, const Voigt<3>& strain, double dx);

}  // namespace arenite::elements
