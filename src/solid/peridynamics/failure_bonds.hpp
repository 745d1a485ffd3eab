#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "model/voxel_map.hpp"
#include "solid/peridynamics/bonds.hpp"
#include "solid/peridynamics/options.hpp"
#include "solid/peridynamics/space/bonds_in_space.hpp"
#include "solid/statics/loading.hpp"

/// What a test to failure asks of bonds, of the plane and of space in the same words.
namespace arenite::peridynamics {

template <int D> struct LatticeIn;
template <> struct LatticeIn<2> {
  using Bonds = peridynamics::Bonds;
  using Words = Buffer<std::uint32_t>;
};
template <> struct LatticeIn<3> {
  using Bonds = SpaceBonds;
  using Words = std::array<Buffer<std::uint32_t>, SpaceBonds::most_words>;
};
template <int D> using BondsIn = typename LatticeIn<D>::Bonds;
/// Types of bonds as `words` of Bonds or SpaceBonds, padded.
template <int D> using WordsIn = typename LatticeIn<D>::Words;

/// The buffers of words; of those of space the last ones may be empty.
inline std::span<Buffer<std::uint32_t>> buffers(WordsIn<2>& words) { return {&words, 1}; }
inline std::span<const Buffer<std::uint32_t>> buffers(const WordsIn<2>& words) { return {&words, 1}; }
inline std::span<Buffer<std::uint32_t>> buffers(WordsIn<3>& words) { return words; }
inline std::span<const Buffer<std::uint32_t>> buffers(const WordsIn<3>& words) { return words; }

/// The word that holds a half bond's type, and where in it.
inline std::uint32_t& word_at(WordsIn<2>& words, std::ptrdiff_t node, int /*d*/) { return words[node]; }
inline std::uint32_t& word_at(WordsIn<3>& words, std::ptrdiff_t node, int d) { return words[d / 16][node]; }
inline int bit_of(int d) { return 2 * (d % 16); }
void clear(auto& words, std::ptrdiff_t node, int d) { word_at(words, node, d) &= ~(3u << bit_of(d)); }

/// One whole bond of a sample in space, as Bond is of one in the plane.
struct SpaceBond {
  std::ptrdiff_t i, j;
  std::int32_t x, y, z;
  int d;
  unsigned type;
  SpaceOffset along;
  SpaceOffset step() const { return along; }
};
/// The levels that a bond's ends lie in.
inline std::array<std::int32_t, 2> levels_of(const Bond& bond) { return {bond.y, bond.y + bond.step().y}; }
inline std::array<std::int32_t, 2> levels_of(const SpaceBond& bond) { return {bond.z, bond.z + bond.along.z}; }

inline int square(Offset e) { return e.x * e.x + e.y * e.y; }
inline int square(SpaceOffset e) { return e.square(); }
inline double along(Offset e, Vec2 v) { return e.x * v.x + e.y * v.y; }
inline double along(SpaceOffset e, Vec3 v) { return e.x * v.x + e.y * v.y + e.z * v.z; }

/// e . (u_j - u_i) of a bond, whose sign is that of its linearised stretch; over |e|^2 dx it is the stretch.
double extension(const auto& bond, const auto& u) { return along(bond.step(), u.at(bond.j) - u.at(bond.i)); }

/// Every bond that `words` hold in one level once, as each_bond_of_row: `visit(Bond)` or `visit(SpaceBond)`.
template <class Visit>
void each_bond_of_level(const Bonds& bonds, const WordsIn<2>& words, int level, const Visit& visit) {
  each_bond_of_row(bonds.grid, words, level, visit);
}
template <class Visit>
void each_bond_of_level(const SpaceBonds& bonds, const WordsIn<3>& words, int level, const Visit& visit) {
  const Grid& grid = bonds.grid;
  for (std::size_t w = 0; w < words.size() && words[w].size() > 0; ++w)
    for (int y = 0; y < grid.height; ++y)
      for (int x = 0; x < grid.width; ++x) {
        const std::ptrdiff_t i = grid.index(x, y, level);
        const std::uint32_t word = words[w][i];
        if (!word) continue;
        const int first = static_cast<int>(16 * w), end = std::min(first + 16, static_cast<int>(bonds.count()));
        for (int d = first; d < end; ++d)
          if (const unsigned type = word >> bit_of(d) & 3u)
            visit(SpaceBond{i, i + bonds.step(d), x, y, level, d, type, bonds.half[d]});
      }
}

/// Force over e (e . du), Pa: in the plane per unit thickness, in space where voxels have unit sides.
inline double stiffness_of(const Bonds& bonds, const Bond& bond) {
  return bonds.modulus(bond.type) / std::pow(length(bond.step()), 3);
}
inline double stiffness_of(const SpaceBonds& bonds, const SpaceBond& bond) {
  return bonds.stiffness_of(static_cast<std::size_t>(bond.d), bond.type);
}
/// Of a bond, twice its energy over its stretch squared: J/m in the plane, J in space.
inline double energy_modulus(const Bonds& bonds, const Bond& bond, double dx) {
  return bonds.modulus(bond.type) * dx * dx * length(bond.step());
}
inline double energy_modulus(const SpaceBonds& bonds, const SpaceBond& bond, double dx) {
  return stiffness_of(bonds, bond) * std::pow(bond.along.square(), 2) * std::pow(dx, 3);
}

/// Those of a sample, whole.
Bonds bonds_of(const PhaseMap& map, const DamageOptionsIn<2>& options);
SpaceBonds bonds_of(const VoxelMap& map, const DamageOptionsIn<3>& options);
/// Breaks every bond that a cut crosses.
void make_cuts(SpaceBonds& bonds, const std::vector<Cut>& cuts);

/// Tells the kernels that bonds of these levels have changed.
inline void mark_changed(Bonds& bonds, int first, int last) { classify_groups(bonds, first, last); }
inline void mark_changed(SpaceBonds& bonds, int /*first*/, int /*last*/) { mark_groups(bonds); }

/// What of a sample is tied to both clamps, for the solver; `bonds` lose the rest, and `tie` says what every node is
/// tied to, padded.
struct Carrying {
  statics::Support support;
  Aggregates aggregates;
};
Carrying carrying(const PhaseMap& map, Bonds& bonds, const std::vector<std::uint8_t>& prescribed,
                  Buffer<statics::Tie>& tie);
Carrying carrying(const VoxelMap& map, SpaceBonds& bonds, const std::vector<std::uint8_t>& prescribed,
                  Buffer<statics::Tie>& tie);

}  // namespace arenite::peridynamics
