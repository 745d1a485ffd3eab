#pragma once
#include <cstring>
#include <utility>

#include "core/lanes.hpp"
#include "solid/statics/discretisation.hpp"
#include "solid/statics/machine.hpp"

namespace arenite::statics {

/// A vector at each of some nodes.
template <class V> struct Force { V x, y; };

namespace {

/// A sum of products a b of the two components of a plane field, in the doubles that the machine keeps sums in, lower
/// lanes first.
class Sum {
 public:
  template <class V> void add(V ax, V bx, V ay, V by) {
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      ((sum_ = fma(part<k>(ax), part<k>(bx), fma(part<k>(ay), part<k>(by), sum_))), ...);
    }
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
  Part sum_{};
};

/// The passes of KernelsOf for one machine. `Sweep` is a discretisation's own: with `At<V>(sample, u).sweep(row, then)`
/// it calls `then(i, own, force)` for every vector of nodes from i on, rows upwards, and `row(y)` before each of them.
template <class Sweep> struct Passes {
  using D = typename Sweep::Of;
  using Doubles = Lanes<double, Machine::bytes / 8>;
  using Floats = Lanes<float, Machine::bytes / 4>;
  template <class V> using At = typename Sweep::template At<V>;

  /// 1 where a component of a row is free to move, 0 where its displacement is prescribed.
  template <class V> static Force<V> freedom(std::uint8_t prescribed) {
    return {V(static_cast<typename V::Scalar>(prescribed & x_prescribed ? 0 : 1)),
            V(static_cast<typename V::Scalar>(prescribed & y_prescribed ? 0 : 1))};
  }

  template <class V, class T = typename V::Scalar>
  static double force(const D& sample, const std::uint8_t* prescribed, Plane<const T> u, Plane<T> f) {
    Sum sum;
    Force<V> open{};
    At<V>(sample, u).sweep([&](int y) { open = freedom<V>(prescribed[y]); },
                           [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
                             g = {open.x * g.x, open.y * g.y};
                             __builtin_prefetch(f.x + i + sample.grid.stride, 1);
                             __builtin_prefetch(f.y + i + sample.grid.stride, 1);
                             g.x.store(f.x + i);
                             g.y.store(f.y + i);
                             sum.add(own.x, g.x, own.y, g.y);
                           });
    return sum.value();
  }

  static double imbalance(const D& sample, const std::uint8_t* prescribed, Plane<const double> u, Plane<float> r) {
    Sum sum;
    Force<Doubles> open{};
    At<Doubles>(sample, u).sweep([&](int y) { open = freedom<Doubles>(prescribed[y]); },
                                 [&](std::ptrdiff_t i, Force<Doubles>, Force<Doubles> g) {
                                   g = {open.x * g.x, open.y * g.y};
                                   g.x.store(r.x + i);
                                   g.y.store(r.y + i);
                                   sum.add(g.x, g.x, g.y, g.y);
                                 });
    return sum.value();
  }

  static void chebyshev(const D& sample, Plane<const float> z, Plane<float> older, Plane<const float> r,
                        BlockPlane inverse, float a, float b) {
    using V = Floats;
    const V va = V(a), vb = V(b);
    At<V>(sample, z).sweep(
        [](int) {},
        [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
          const V rx = V::load(r.x + i) + g.x, ry = V::load(r.y + i) + g.y, xy = V::load(inverse.xy + i);
          const V dx = fma(V::load(inverse.xx + i), rx, xy * ry), dy = fma(xy, rx, V::load(inverse.yy + i) * ry);
          fma(vb, dx, fma(va, own.x - V::load(older.x + i), own.x)).store(older.x + i);
          fma(vb, dy, fma(va, own.y - V::load(older.y + i), own.y)).store(older.y + i);
        });
  }

  static void residual(const D& sample, Plane<const float> z, Plane<const float> r, Plane<float> out) {
    using V = Floats;
    At<V>(sample, z).sweep([](int) {},
                           [&](std::ptrdiff_t i, Force<V>, Force<V> g) {
                             (V::load(r.x + i) + g.x).store(out.x + i);
                             (V::load(r.y + i) + g.y).store(out.y + i);
                           });
  }

  static double stormer(const D& sample, const std::uint8_t* prescribed, Plane<const double> u, Plane<double> older,
                        double a, double b) {
    using V = Doubles;
    const V va = V(a), vb = V(b);
    Sum sum;
    Force<V> open{};
    At<V>(sample, u).sweep([&](int y) { open = freedom<V>(prescribed[y]); },
                           [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
                             g = {open.x * g.x, open.y * g.y};
                             __builtin_prefetch(older.x + i + sample.grid.stride, 1);
                             __builtin_prefetch(older.y + i + sample.grid.stride, 1);
                             sum.add(g.x, g.x, g.y, g.y);
                             fma(vb, g.x, fma(va, own.x - V::load(older.x + i), own.x)).store(older.x + i);
                             fma(vb, g.y, fma(va, own.y - V::load(older.y + i), own.y)).store(older.y + i);
                           });
    return sum.value();
  }

  static double relax(const D& sample, Plane<const double> u, Plane<double> older, BlockPlane inverse, double a,
                      double b) {
    using V = Doubles;
    const V va = V(a), vb = V(b);
    Sum sum;
    At<V>(sample, u).sweep([](int) {},
                           [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
                             __builtin_prefetch(older.x + i + sample.grid.stride, 1);
                             __builtin_prefetch(older.y + i + sample.grid.stride, 1);
                             const V xx = Doubles::load(inverse.xx + i), xy = Doubles::load(inverse.xy + i),
                                     yy = Doubles::load(inverse.yy + i);
                             const V dx = fma(xx, g.x, xy * g.y), dy = fma(xy, g.x, yy * g.y);
                             sum.add(dx, g.x, dy, g.y);
                             fma(vb, dx, fma(va, own.x - V::load(older.x + i), own.x)).store(older.x + i);
                             fma(vb, dy, fma(va, own.y - V::load(older.y + i), own.y)).store(older.y + i);
                           });
    return sum.value();
  }

  /// Every vector of nodes of a grid, pads between the rows included: these hold zeros and stay so.
  template <class Visit> [[gnu::always_inline]] static void each_vector(const Grid& grid, const Visit& visit) {
    for (std::ptrdiff_t i = grid.row(0), end = grid.row(grid.height); i < end; i += Floats::lanes) visit(i);
  }

  static double conjugate_step(const D& sample, float alpha, Plane<const float> p, Plane<const float> f,
                               Plane<double> u, Plane<float> r, BlockPlane inverse, float b, Plane<float> z) {
    const Floats step = Floats(alpha), vb = Floats(b);
    const Doubles long_step = Doubles(static_cast<double>(alpha));
    Sum sum;
    const auto component = [&](std::ptrdiff_t i, const float* pp, const float* ff, double* uu, float* rr) {
      for (std::ptrdiff_t j = i; j < i + Floats::lanes; j += Doubles::lanes)
        fma(long_step, Doubles::load(pp + j), Doubles::load(uu + j)).store(uu + j);
      const Floats now = fma(step, Floats::load(ff + i), Floats::load(rr + i));
      now.store(rr + i);
      return now;
    };
    each_vector(sample.grid, [&](std::ptrdiff_t i) {
      const Floats rx = component(i, p.x, f.x, u.x, r.x), ry = component(i, p.y, f.y, u.y, r.y);
      sum.add(rx, rx, ry, ry);
      const Floats xy = Floats::load(inverse.xy + i);
      (vb * fma(Floats::load(inverse.xx + i), rx, xy * ry)).store(z.x + i);
      (vb * fma(xy, rx, Floats::load(inverse.yy + i) * ry)).store(z.y + i);
    });
    return sum.value();
  }

  static double dot(const D& sample, Plane<const float> a, Plane<const float> b) {
    Sum sum;
    each_vector(sample.grid, [&](std::ptrdiff_t i) {
      sum.add(Floats::load(a.x + i), Floats::load(b.x + i), Floats::load(a.y + i), Floats::load(b.y + i));
    });
    return sum.value();
  }

  static void direct(const D& sample, float beta, Plane<const float> z, Plane<float> p) {
    const Floats keep = Floats(beta);
    each_vector(sample.grid, [&](std::ptrdiff_t i) {
      fma(keep, Floats::load(p.x + i), Floats::load(z.x + i)).store(p.x + i);
      fma(keep, Floats::load(p.y + i), Floats::load(z.y + i)).store(p.y + i);
    });
  }

  static constexpr KernelsOf<D> table(const char* name) {
    return {name,    force<Doubles>, force<Floats>,  imbalance, chebyshev, residual,
            stormer, relax,          conjugate_step, dot,       direct};
  }
};

}  // namespace
}  // namespace arenite::statics
