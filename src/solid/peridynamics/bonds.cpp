#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/error.hpp"
#include "solid/peridynamics/bonds.hpp"

namespace arenite::peridynamics {
namespace {

using Lane = std::int32_t __attribute__((vector_size(16)));
constexpr int lane_nodes = 4;

Lane load(const void* p) {
  Lane v;
  std::memcpy(&v, p, sizeof v);
  return v;
}

bool all_zero(Lane v) {
  std::uint64_t w[2];
  std::memcpy(w, &v, sizeof w);
  return (w[0] | w[1]) == 0;
}

/// 0: void, 1: matrix, 2 and more: a grain.
Buffer<std::int32_t> padded_labels(const PhaseMap& map, const Grid& grid) {
  Buffer<std::int32_t> labels(grid.padded_size());
  std::size_t k = 0;
  grid.each([&](std::ptrdiff_t i, int) {
    labels[i] = map.phase[k] == Phase::particle ? map.grain[k] + 2 : static_cast<std::int32_t>(map.phase[k]);
    ++k;
  });
  return labels;
}

bool crosses(const Cut& cut, Vec2 a, Vec2 b) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) { return cross(q - p, r - p); };
  return side(cut.from, cut.to, a) * side(cut.from, cut.to, b) < 0 && side(a, b, cut.from) * side(a, b, cut.to) <= 0;
}

}  // namespace

void check_by_type(const LawParameter& parameter, double matrix, double interface, double particle) {
  for (const auto& [type, value] : {std::pair{"matrix", matrix}, std::pair{"interface", interface}, std::pair{"particle", particle}})
    if (!parameter.range.contains(value) || !std::isfinite(value))
      throw InputError(fmt::format("the {} of {} bonds is {:g} {}; give a positive one", parameter.name, type, value, parameter.unit));
}

Bonds make_bonds(const PhaseMap& map, const Stiffness& stiffness, const BondLawChoice& law) {
  check(map);
  std::visit([&](const auto& l) { check_by_type(l.young, stiffness.matrix, stiffness.interface, stiffness.particle); }, law);
  if (std::min(map.width, map.height) < 2 * horizon + 1)
    throw InputError(fmt::format("a phase map of {} x {} nodes is narrower than the horizon of a node; give at least {} nodes each way", map.width, map.height,
                                 2 * horizon + 1));
  Bonds bonds;
  bonds.law = law;
  bonds.grid = Grid(map.width, map.height);
  const Grid& grid = bonds.grid;
  bonds.scale = nominal_micromodulus * (stiffness.calibrated ? calibration_factor() : 1.0) * stiffness.matrix;
  bonds.relative = {0.0f, 1.0f, static_cast<float>(stiffness.interface / stiffness.matrix), static_cast<float>(stiffness.particle / stiffness.matrix)};
  bonds.words = Buffer<std::uint32_t>(grid.padded_size());
  bonds.group = Buffer<std::uint8_t>(static_cast<std::size_t>(grid.groups) * static_cast<std::size_t>(grid.height));

  const auto labels = padded_labels(map, grid);
  constexpr std::int32_t matrix = matrix_bond, interface = interface_bond, particle = particle_bond;
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; x += lane_nodes) {
      const std::ptrdiff_t i = grid.index(x, y);
      const Lane own = load(labels.data() + i), solid = own != 0;
      const Lane within = ((own == 1) & matrix) | ((own > 1) & particle);
      Lane word = own ^ own;
      for (int d = 0; d < bonds_per_node; ++d) {
        const Lane other = load(labels.data() + i + bonds.step(d));
        const Lane same = own == other;
        word |= ((same & within) | (~same & solid & (other != 0) & interface)) << (2 * d);
      }
      std::memcpy(bonds.words.data() + i, &word, sizeof word);
    }
  classify_groups(bonds, 0, grid.height - 1);
  return bonds;
}

void classify_groups(Bonds& bonds, int first, int last) {
  const Grid& grid = bonds.grid;
  for (int y = std::max(0, first); y <= std::min(grid.height - 1, last + horizon); ++y)
    for (int g = 0; g < grid.groups; ++g) {
      const std::ptrdiff_t begin = grid.row(y) + g * Grid::lanes;
      const auto t = static_cast<std::int32_t>(bonds.words[begin] & 3u);
      Lane any{}, differs{};
      for (std::ptrdiff_t i = begin; i < begin + Grid::lanes; i += lane_nodes) {
        const Lane word = load(bonds.words.data() + i);
        any |= word;
        for (int d = 0; d < bonds_per_node; ++d) {
          const Lane back = (load(bonds.words.data() + i - bonds.step(d)) >> (2 * d)) & 3;
          differs |= ((word >> (2 * d) & 3) - t) | (back - t);
          any |= back;
        }
      }
      std::uint8_t& group = bonds.group[static_cast<std::ptrdiff_t>(y) * grid.groups + g];
      group = Bonds::mixed;
      if (all_zero(any)) group = Bonds::empty;
      else if (all_zero(differs)) group = static_cast<std::uint8_t>(t);
    }
}

void make_cuts(Bonds& bonds, const std::vector<Cut>& cuts) {
  if (cuts.empty()) return;
  each_bond(bonds, [&](const Bond& b) {
    const Vec2 from{static_cast<double>(b.x), static_cast<double>(b.y)}, to{static_cast<double>(b.x + b.step().x), static_cast<double>(b.y + b.step().y)};
    if (std::any_of(cuts.begin(), cuts.end(), [&](const Cut& cut) { return crosses(cut, from, to); })) bonds.break_bond(b.i, b.d);
  });
  classify_groups(bonds, 0, bonds.grid.height - 1);
}

}  // namespace arenite::peridynamics
