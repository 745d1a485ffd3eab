#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>
#include <variant>

#include "solid/peridynamics/kernels/kernels.hpp"
#include "solid/statics/passes.hpp"

/// The 28-neighbour force, row by row.
///
/// Each bond is worked out once, by the node that it starts from: a first pass over a row of a tile writes the tensions
/// of its 14 half bonds a node, a second adds up, for each node, those that start there less those that end there.
/// Tensions live in a ring of as many rows as the bonds reach, which stays in the nearest cache.
namespace arenite::peridynamics {

using statics::Force;

/// Place of a half bond among those that reach as many rows: 3 stay in theirs, 5 reach the next, 5 the one after, 1 the
/// third.
inline constexpr std::array<int, bonds_per_node> place{0, 1, 2, 0, 0, 0, 1, 1, 2, 2, 3, 4, 3, 4};

/// p . u for the primitive direction of half bond d.
template <int d, class V> [[gnu::always_inline]] inline V along(V x, V y, V two) {
  constexpr int px = half_bonds[d].x, py = half_bonds[d].y;
  if constexpr (py == 0) return x;
  else if constexpr (px == 0) return y;
  else if constexpr (px == py) return x + y;
  else if constexpr (px == -py) return y - x;
  else if constexpr (px == 2) return fma(two, x, y);
  else if constexpr (px == -2) return fnma(two, x, y);
  else if constexpr (px == 1) return fma(two, y, x);
  else return two * y - x;
}

template <class Machine, class V, BondLaw Law> class Stencil {
 public:
  using T = typename V::Scalar;
  static constexpr int lanes = V::lanes;
  static constexpr int tile = 4096 / static_cast<int>(sizeof(T));
  static constexpr int pitch = tile + 2 * lanes;

  Stencil(const Bonds& bonds, Plane<const T> u)
      : grid_(bonds.grid),
        words_(bonds.words.data()),
        u_(u),
        bonds_(bonds),
        law_(*std::get_if<Law>(&bonds.law)) {}

  static V all(double c) { return V(static_cast<T>(c)); }

  /// Calls `then(i, own, force)` for every vector of nodes from i on, tile by tile, rows upwards in each;
  /// `row(y)` is called before each row of a tile.
  template <class Row, class Then> [[gnu::always_inline]] void sweep(const Row& row, const Then& then) {
    for (int x = 0; x < grid_.row_vectors() * Grid::vector; x += tile) {
      const int nodes = std::min(tile, grid_.row_vectors() * Grid::vector - x);
      std::memset(ring_, 0, sizeof ring_);
      for (int y = 0; y < grid_.height; ++y) {
        pull(grid_.index(x, y), nodes, {slot(0, 0), slot(1, y), slot(2, y), slot(3, y)});
        row(y);
        add(grid_.index(x, y), nodes, {slot(0, 0), slot(1, y), slot(2, y), slot(3, y)},
            {slot(0, 0), slot(1, y + 1), slot(2, y + 1), slot(3, y + 1)}, then);
      }
    }
  }

 private:
  /// Tensions of one row, by reach of the bonds.
  struct Rows {
    T *r0, *r1, *r2, *r3;
  };
  template <int d> static T* in(const Rows& rows) {
    constexpr int reach = half_bonds[d].y;
    T* const base = reach == 0 ? rows.r0 : reach == 1 ? rows.r1 : reach == 2 ? rows.r2 : rows.r3;
    return base + place[d] * pitch;
  }
  T* slot(int reach, int y) {
    return ring_ + pitch * (reach == 0 ? 0 : reach == 1 ? 3 + 5 * (y % 2) : reach == 2 ? 13 + 5 * (y % 3) : 28 + y % 4);
  }

  /// Tensions of the bonds that start in a row of the tile and, for bonds into it, one vector on either side.
  [[gnu::always_inline]] void pull(std::ptrdiff_t first, int nodes, const Rows rows) const {
    const auto table = typename Machine::template Table<V>(bonds_.relative.data());
    const V two = V(2);
    const std::ptrdiff_t stride = grid_.stride;
    const T* const ux = u_.x + first - lanes;
    const T* const uy = u_.y + first - lanes;
    const std::uint32_t* const words = words_ + first - lanes;
    for (std::ptrdiff_t k = 0; k < nodes + 2 * lanes; k += lanes) {
      __builtin_prefetch(ux + k + 4 * stride);  // the row that the next one will be the first to ask for
      __builtin_prefetch(uy + k + 4 * stride);
      __builtin_prefetch(words + k + stride);
      const auto word = typename Machine::template Words<lanes>(words + k);
      const V x = V::load(ux + k), y = V::load(uy + k);
      const auto one = [&]<int d>() __attribute__((always_inline)) {
        constexpr Offset e = half_bonds[d];
        const std::ptrdiff_t j = k + e.x + e.y * stride;
        const V other = along<d>(V::load(ux + j), V::load(uy + j), two);
        law_.force(other - along<d>(x, y, two), table.template find<2 * d>(word)).store(in<d>(rows) + k);
      };
      [&]<int... d>(std::integer_sequence<int, d...>) __attribute__((always_inline)) {
        (one.template operator()<d>(), ...);
      }
      (std::make_integer_sequence<int, bonds_per_node>());
    }
  }

  template <class Then>
  [[gnu::always_inline]] void add(std::ptrdiff_t first, int nodes, const Rows starting, const Rows ending,
                                  const Then& then) const {
    const double root2 = std::sqrt(2.0), root5 = std::sqrt(5.0), scale = bonds_.scale;
    const V axis1 = all(scale), axis2 = all(scale / 2), axis3 = all(scale / 3), two = V(2);
    const V diagonal1 = all(scale / (2 * root2)), diagonal2 = all(scale / (4 * root2)),
            knight = all(scale / (5 * root5));
    const Plane<const T> u = u_;
    for (std::ptrdiff_t k = 0; k < nodes; k += lanes) {
      const auto net = [&]<int d>() __attribute__((always_inline)) {
        return V::load(in<d>(starting) + k + lanes) - V::load(in<d>(ending) + k + lanes - half_bonds[d].x);
      };
      V x = fma(axis3, net.template operator()<2>(),
                fma(axis2, net.template operator()<1>(), axis1 * net.template operator()<0>()));
      V y = fma(axis3, net.template operator()<5>(),
                fma(axis2, net.template operator()<4>(), axis1 * net.template operator()<3>()));
      const V rising = fma(diagonal2, net.template operator()<7>(), diagonal1 * net.template operator()<6>());
      const V falling = fma(diagonal2, net.template operator()<9>(), diagonal1 * net.template operator()<8>());
      const V a = net.template operator()<10>(), b = net.template operator()<11>();
      const V p = net.template operator()<12>(), q = net.template operator()<13>();
      x = fma(knight, fma(two, a - b, p - q), x + (rising - falling));
      y = fma(knight, fma(two, p + q, a + b), y + (rising + falling));
      const std::ptrdiff_t i = first + k;
      then(i, Force<V>{V::load(u.x + i), V::load(u.y + i)}, Force<V>{x, y});
    }
  }

  const Grid grid_;
  const std::uint32_t* words_;
  Plane<const T> u_;
  const Bonds& bonds_;
  const Law law_;
  alignas(64) T ring_[32 * pitch];
};

/// The passes of the static solver and of dynamics over bonds of a law.
template <BondLaw Law> struct BondSweep {
  using Of = Bonds;
  template <class V> using At = Stencil<statics::Machine, V, Law>;
};

namespace {

template <class... Law> constexpr KernelSet every_law(std::variant<Law...>*) {
  constexpr const char* name = statics::Machine::name;
  return {name, {statics::Passes<BondSweep<Law>>::table(name)...}};
}

/// The passes for every law that there is, for the processor that the source is compiled for.
constexpr KernelSet kernel_set() { return every_law(static_cast<BondLawChoice*>(nullptr)); }

}  // namespace

}  // namespace arenite::peridynamics
