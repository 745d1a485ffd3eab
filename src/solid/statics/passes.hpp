#pragma once
#include <cstdint>
#include <cstring>
#include <utility>

#include "core/lanes.hpp"
#include "solid/statics/discretisation.hpp"
#include "solid/statics/machine.hpp"
#include "solid/statics/pool.hpp"

namespace arenite::statics {

/// A vector at each of some nodes.
template <int D, class V> struct ForceIn;
template <class V> struct ForceIn<2, V> {
  V x, y;
  ARENITE_INLINE V& operator[](int axis) { return axis == 0 ? x : y; }
  ARENITE_INLINE const V& operator[](int axis) const { return axis == 0 ? x : y; }
};
template <class V> struct ForceIn<3, V> {
  V x, y, z;
  ARENITE_INLINE V& operator[](int axis) { return axis == 0 ? x : axis == 1 ? y : z; }
  ARENITE_INLINE const V& operator[](int axis) const { return axis == 0 ? x : axis == 1 ? y : z; }
};
template <class V> using Force = ForceIn<2, V>;

namespace {

/// visit(0), visit(1), ..: of every component, or from the last one down.
template <int D, class Visit> ARENITE_INLINE void by_component(const Visit& visit) {
  [&]<int... c>(std::integer_sequence<int, c...>) __attribute__((always_inline)) { (visit(c), ...); }
  (std::make_integer_sequence<int, D>());
}
template <int D, class Visit> ARENITE_INLINE void by_component_down(const Visit& visit) {
  [&]<int... c>(std::integer_sequence<int, c...>) __attribute__((always_inline)) { (visit(D - 1 - c), ...); }
  (std::make_integer_sequence<int, D>());
}

/// Nodes of a row that repeat the first ones of a period, beyond so many inside, feel nothing.
template <int D, class V> ARENITE_INLINE void clear_beyond(int inside, ForceIn<D, V>& force) {
  using T = typename V::Scalar;
  T mask[V::lanes];
  for (int k = 0; k < V::lanes; ++k) mask[k] = T(k < inside ? 1 : 0);
  by_component<D>([&](int c) { force[c] = V::load(mask) * force[c]; });
}

/// A sum of products a b of the components of a field, in the doubles that the machine keeps sums in, lower lanes
/// first.
class Sum {
 public:
  template <int D, class V> ARENITE_INLINE void add(const ForceIn<D, V>& a, const ForceIn<D, V>& b) {
    [&]<std::size_t... k>(std::index_sequence<k...>) __attribute__((always_inline)) { (add_part<k>(a, b), ...); }
    (std::make_index_sequence<V::lanes / n>());
  }
  double value() const {
    double p[n];
    sum_.store(p);
    if constexpr (n == 2) return p[0] + p[1];
    else return (p[0] + p[1]) + (p[2] + p[3]);
  }

 private:
  static constexpr int n = Machine::sum_lanes;
  using Part = Lanes<double, n>;
  template <std::size_t k, class V> [[gnu::always_inline]] static Part part(V numbers) {
    return Machine::template doubles<k>(numbers.v);
  }
  template <std::size_t k, int D, class V>
  ARENITE_INLINE void add_part(const ForceIn<D, V>& a, const ForceIn<D, V>& b) {
    by_component_down<D>([&](int c) { sum_ = fma(part<k>(a[c]), part<k>(b[c]), sum_); });
  }
  Part sum_{};
};

/// The passes of KernelsOf for one machine. `Sweep` is a discretisation's own: with `At<V>(sample, u).sweep(level,
/// then)` it calls `then(i, own, force)` for every vector of nodes from i on, rows upwards, and `level(y)` before each
/// row. One that has `blocks(sample)` does so in blocks of rows, `sweep(block, level, then)`, by any thread each; sums
/// are those of the blocks in their order.
template <class Sweep> struct Passes {
  using D = typename Sweep::Of;
  static constexpr int dimension = D::dimension;
  using Doubles = Lanes<double, Machine::bytes / 8>;
  using Floats = Lanes<float, Machine::bytes / 4>;
  template <class V> using At = typename Sweep::template At<V>;
  template <class V> using Vector = ForceIn<dimension, V>;
  template <class T> using To = PointersIn<dimension, T>;
  using Inverse = BlockPointers<dimension>;

  /// 1 where a component of a level is free to move, 0 where its displacement is prescribed.
  template <class V> static Vector<V> freedom(std::uint8_t prescribed) {
    Vector<V> open{};
    by_component<dimension>([&](int c) { open[c] = V(static_cast<typename V::Scalar>(prescribed >> c & 1 ? 0 : 1)); });
    return open;
  }
  template <class V, class T> ARENITE_INLINE static Vector<V> load(To<T> field, std::ptrdiff_t i) {
    Vector<V> at{};
    by_component<dimension>([&](int c) { at[c] = V::load(field[c] + i); });
    return at;
  }
  /// The inverse blocks of some nodes times v.
  template <class V> ARENITE_INLINE static Vector<V> solved(const Inverse& inverse, std::ptrdiff_t i, Vector<V> v) {
    Vector<V> product;
    by_component<dimension>([&](int a) __attribute__((always_inline)) {
      const auto block = [&](int b) __attribute__((always_inline)) { return V::load(inverse(a, b) + i); };
      product[a] = block(dimension - 1) * v[dimension - 1];
      by_component_down<dimension - 1>([&](int b) __attribute__((always_inline)) {
        product[a] = fma(block(b), v[b], product[a]);
      });
    });
    return product;
  }
  /// older := own + a (own - older) + b step.
  template <class V, class T>
  ARENITE_INLINE static void put(To<T> older, std::ptrdiff_t i, const Vector<V>& own, V a, V b, const Vector<V>& step) {
    by_component<dimension>(
        [&](int c) { fma(b, step[c], fma(a, own[c] - V::load(older[c] + i), own[c])).store(older[c] + i); });
  }

  static constexpr int most_parts = 1024;
  static constexpr bool is_in_blocks = requires(const D& sample) { Sweep::blocks(sample); };

  /// visit(i, own, force, open, sum) for all vectors of nodes, with what is open at their level unless nothing is
  /// prescribed; returns the sum. In blocks, nodes that nothing touches may be left out.
  template <class V, bool everywhere = true, class Visit, class T = typename V::Scalar>
  [[gnu::always_inline]] static double sweep(const D& sample, const std::uint8_t* prescribed, To<const T> u,
                                             const Visit& visit) {
    const auto through = [&](auto&& walk) __attribute__((always_inline)) {
      Sum sum;
      Vector<V> open{};
      walk(
          [&](int level) {
            if (prescribed) open = freedom<V>(prescribed[level]);
          },
          [&](std::ptrdiff_t i, const Vector<V>& own, Vector<V> g)
              __attribute__((always_inline)) { visit(i, own, g, open, sum); });
      return sum.value();
    };
    if constexpr (is_in_blocks)
      return summed(sample, Sweep::blocks(sample), [&](std::size_t block) {
        return through([&](const auto& level, const auto& then) __attribute__((always_inline)) {
          At<V>(sample, u).template sweep<everywhere>(static_cast<int>(block), level, then);
        });
      });
    else
      return through([&](const auto& level, const auto& then)
                         __attribute__((always_inline)) { At<V>(sample, u).sweep(level, then); });
  }
  /// The sum of what parts give, in their order.
  template <class Part> static double summed(const D& sample, int count, const Part& part) {
    double each[most_parts], sum = 0;
    for_each(sample.pool, static_cast<std::size_t>(count), [&](std::size_t k) { each[k] = part(k); });
    for (int k = 0; k < count; ++k) sum += each[k];
    return sum;
  }

  template <class V, class T = typename V::Scalar>
  static double force(const D& sample, const std::uint8_t* prescribed, To<const T> u, To<T> f) {
    return sweep<V>(sample, prescribed, u,
                    [&](std::ptrdiff_t i, const Vector<V>& own, Vector<V>& g, const Vector<V>& open, Sum& sum) {
                      by_component<dimension>([&](int c) {
                        g[c] = open[c] * g[c];
                        __builtin_prefetch(f[c] + i + sample.grid.stride, 1);
                        g[c].store(f[c] + i);
                      });
                      sum.add(own, g);
                    });
  }

  static double imbalance(const D& sample, const std::uint8_t* prescribed, To<const double> u, To<float> r) {
    using V = Doubles;
    return sweep<V>(sample, prescribed, u,
                    [&](std::ptrdiff_t i, const Vector<V>&, Vector<V>& g, const Vector<V>& open, Sum& sum) {
                      by_component<dimension>([&](int c) {
                        g[c] = open[c] * g[c];
                        g[c].store(r[c] + i);
                      });
                      sum.add(g, g);
                    });
  }

  static void chebyshev(const D& sample, To<const float> z, To<float> older, To<const float> r, Inverse inverse,
                        float a, float b) {
    using V = Floats;
    const V va = V(a), vb = V(b);
    // What nothing touches has no force and rests at zero.
    sweep<V, false>(sample, nullptr, z,
                    [&](std::ptrdiff_t i, const Vector<V>& own, Vector<V>& g, const Vector<V>&, Sum&) {
                      by_component<dimension>([&](int c) { g[c] = V::load(r[c] + i) + g[c]; });
                      put(older, i, own, va, vb, solved(inverse, i, g));
                    });
  }

  static void residual(const D& sample, To<const float> z, To<const float> r, To<float> out) {
    using V = Floats;
    sweep<V>(sample, nullptr, z, [&](std::ptrdiff_t i, const Vector<V>&, Vector<V>& g, const Vector<V>&, Sum&) {
      by_component<dimension>([&](int c) { (V::load(r[c] + i) + g[c]).store(out[c] + i); });
    });
  }

  static double stormer(const D& sample, const std::uint8_t* prescribed, To<const double> u, To<double> older, double a,
                        double b) {
    using V = Doubles;
    const V va = V(a), vb = V(b);
    return sweep<V>(sample, prescribed, u,
                    [&](std::ptrdiff_t i, const Vector<V>& own, Vector<V>& g, const Vector<V>& open, Sum& sum) {
                      by_component<dimension>([&](int c) {
                        g[c] = open[c] * g[c];
                        __builtin_prefetch(older[c] + i + sample.grid.stride, 1);
                      });
                      sum.add(g, g);
                      put(older, i, own, va, vb, g);
                    });
  }

  static double relax(const D& sample, To<const double> u, To<double> older, Inverse inverse, double a, double b) {
    using V = Doubles;
    const V va = V(a), vb = V(b);
    return sweep<V>(sample, nullptr, u,
                    [&](std::ptrdiff_t i, const Vector<V>& own, Vector<V>& g, const Vector<V>&, Sum& sum) {
                      by_component<dimension>([&](int c) { __builtin_prefetch(older[c] + i + sample.grid.stride, 1); });
                      const Vector<V> step = solved(inverse, i, g);
                      sum.add(step, g);
                      put(older, i, own, va, vb, step);
                    });
  }

  /// visit(i, sum) for every vector of nodes, pads between the rows included: these hold zeros and stay so. Returns the
  /// sum.
  template <class Visit> [[gnu::always_inline]] static double each_vector(const D& sample, const Visit& visit) {
    const Grid& grid = sample.grid;
    const auto between = [&](std::ptrdiff_t i, std::ptrdiff_t end) __attribute__((always_inline)) {
      Sum sum;
      for (; i < end; i += Floats::lanes) visit(i, sum);
      return sum.value();
    };
    const std::ptrdiff_t begin = grid.row(0), end = grid.row(grid.height - 1, grid.depth - 1) + grid.stride;
    if constexpr (is_in_blocks) {
      constexpr int count = 64;
      const auto cut = [&](std::ptrdiff_t k) {
        return begin + (end - begin) * k / count / Grid::vector * Grid::vector;
      };
      return summed(sample, count, [&](std::size_t k) {
        const auto block = static_cast<std::ptrdiff_t>(k);
        return between(cut(block), block + 1 == count ? end : cut(block + 1));
      });
    } else {
      return between(begin, end);
    }
  }

  static double conjugate_step(const D& sample, float alpha, To<const float> p, To<const float> f, To<double> u,
                               To<float> r, Inverse inverse, float b, To<float> z) {
    const Floats step = Floats(alpha), vb = Floats(b);
    const Doubles long_step = Doubles(static_cast<double>(alpha));
    return each_vector(sample, [&](std::ptrdiff_t i, Sum& sum) {
      Vector<Floats> now{};
      by_component<dimension>([&](int c) {
        for (std::ptrdiff_t j = i; j < i + Floats::lanes; j += Doubles::lanes)
          fma(long_step, Doubles::load(p[c] + j), Doubles::load(u[c] + j)).store(u[c] + j);
        now[c] = fma(step, Floats::load(f[c] + i), Floats::load(r[c] + i));
        now[c].store(r[c] + i);
      });
      sum.add(now, now);
      const Vector<Floats> first = solved(inverse, i, now);
      by_component<dimension>([&](int c) { (vb * first[c]).store(z[c] + i); });
    });
  }

  static double dot(const D& sample, To<const float> a, To<const float> b) {
    return each_vector(sample, [&](std::ptrdiff_t i, Sum& sum) { sum.add(load<Floats>(a, i), load<Floats>(b, i)); });
  }

  static void direct(const D& sample, float beta, To<const float> z, To<float> p) {
    const Floats keep = Floats(beta);
    each_vector(sample, [&](std::ptrdiff_t i, Sum&) {
      by_component<dimension>(
          [&](int c) { fma(keep, Floats::load(p[c] + i), Floats::load(z[c] + i)).store(p[c] + i); });
    });
  }

  static constexpr KernelsOf<D> table(const char* name) {
    return {name,    force<Doubles>, force<Floats>,  imbalance, chebyshev, residual,
            stormer, relax,          conjugate_step, dot,       direct};
  }
};

}  // namespace
}  // namespace arenite::statics
