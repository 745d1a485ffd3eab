#pragma once
#include <cstring>
#include <utility>

#include "core/lanes.hpp"
#include "solid/peridynamics/kernels/stencil.hpp"

namespace arenite::peridynamics {

/// A sum of products a b of the two components of a plane field, in the doubles that the machine keeps sums in, lower
/// lanes first.
template <class Machine> class Sum {
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

/// The passes of Kernels for one machine and one law. `Machine` says how many bytes its vectors hold (`bytes`), how
/// many doubles a sum is kept in (`sum_lanes`) and how a vector is cut into as many (`doubles`), and how one of four
/// moduli is found for every lane (`Words`, `Table`). Each is a type of its own source, in an unnamed namespace, so
/// that nothing compiled for one processor is ever linked into another's loops.
template <class Machine, BondLaw Law> struct Passes {
  using Doubles = Lanes<double, Machine::bytes / 8>;
  using Floats = Lanes<float, Machine::bytes / 4>;

  /// 1 where a component of a row is free to move, 0 where its displacement is prescribed.
  template <class V> static Force<V> freedom(std::uint8_t prescribed) {
    return {Stencil<Machine, V, Law>::all(prescribed & x_prescribed ? 0 : 1),
            Stencil<Machine, V, Law>::all(prescribed & y_prescribed ? 0 : 1)};
  }

  template <class V, class T = typename V::Scalar>
  static double force(const Bonds& bonds, const std::uint8_t* prescribed, Plane<const T> u, Plane<T> f) {
    Sum<Machine> sum;
    Force<V> open{};
    Stencil<Machine, V, Law>(bonds, u).sweep([&](int y) { open = freedom<V>(prescribed[y]); },
                                             [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
                                               g = {open.x * g.x, open.y * g.y};
                                               __builtin_prefetch(f.x + i + bonds.grid.stride, 1);
                                               __builtin_prefetch(f.y + i + bonds.grid.stride, 1);
                                               g.x.store(f.x + i);
                                               g.y.store(f.y + i);
                                               sum.add(own.x, g.x, own.y, g.y);
                                             });
    return sum.value();
  }

  static double imbalance(const Bonds& bonds, const std::uint8_t* prescribed, Plane<const double> u, Plane<float> r) {
    Sum<Machine> sum;
    Force<Doubles> open{};
    Stencil<Machine, Doubles, Law>(bonds, u).sweep([&](int y) { open = freedom<Doubles>(prescribed[y]); },
                                                   [&](std::ptrdiff_t i, Force<Doubles>, Force<Doubles> g) {
                                                     g = {open.x * g.x, open.y * g.y};
                                                     g.x.store(r.x + i);
                                                     g.y.store(r.y + i);
                                                     sum.add(g.x, g.x, g.y, g.y);
                                                   });
    return sum.value();
  }

  static void chebyshev(const Bonds& bonds, Plane<const float> z, Plane<float> older, Plane<const float> r,
                        BlockPlane inverse, float a, float b) {
    using V = Floats;
    const V va = V(a), vb = V(b);
    Stencil<Machine, V, Law>(bonds, z).sweep(
        [](int) {},
        [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
          const V rx = V::load(r.x + i) + g.x, ry = V::load(r.y + i) + g.y, xy = V::load(inverse.xy + i);
          const V dx = fma(V::load(inverse.xx + i), rx, xy * ry), dy = fma(xy, rx, V::load(inverse.yy + i) * ry);
          fma(vb, dx, fma(va, own.x - V::load(older.x + i), own.x)).store(older.x + i);
          fma(vb, dy, fma(va, own.y - V::load(older.y + i), own.y)).store(older.y + i);
        });
  }

  static void residual(const Bonds& bonds, Plane<const float> z, Plane<const float> r, Plane<float> out) {
    using V = Floats;
    Stencil<Machine, V, Law>(bonds, z).sweep([](int) {},
                                             [&](std::ptrdiff_t i, Force<V>, Force<V> g) {
                                               (V::load(r.x + i) + g.x).store(out.x + i);
                                               (V::load(r.y + i) + g.y).store(out.y + i);
                                             });
  }

  static double stormer(const Bonds& bonds, const std::uint8_t* prescribed, Plane<const double> u, Plane<double> older,
                        double a, double b) {
    using V = Doubles;
    const V va = V(a), vb = V(b);
    Sum<Machine> sum;
    Force<V> open{};
    Stencil<Machine, V, Law>(bonds, u).sweep(
        [&](int y) { open = freedom<V>(prescribed[y]); },
        [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
          g = {open.x * g.x, open.y * g.y};
          __builtin_prefetch(older.x + i + bonds.grid.stride, 1);
          __builtin_prefetch(older.y + i + bonds.grid.stride, 1);
          sum.add(g.x, g.x, g.y, g.y);
          fma(vb, g.x, fma(va, own.x - V::load(older.x + i), own.x)).store(older.x + i);
          fma(vb, g.y, fma(va, own.y - V::load(older.y + i), own.y)).store(older.y + i);
        });
    return sum.value();
  }

  static double relax(const Bonds& bonds, Plane<const double> u, Plane<double> older, BlockPlane inverse, double a,
                      double b) {
    using V = Doubles;
    const V va = V(a), vb = V(b);
    Sum<Machine> sum;
    Stencil<Machine, V, Law>(bonds, u).sweep(
        [](int) {},
        [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
          __builtin_prefetch(older.x + i + bonds.grid.stride, 1);
          __builtin_prefetch(older.y + i + bonds.grid.stride, 1);
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

  static double conjugate_step(const Bonds& bonds, float alpha, Plane<const float> p, Plane<const float> f,
                               Plane<double> u, Plane<float> r, BlockPlane inverse, float b, Plane<float> z) {
    const Floats step = Floats(alpha), vb = Floats(b);
    const Doubles long_step = Doubles(static_cast<double>(alpha));
    Sum<Machine> sum;
    const auto component = [&](std::ptrdiff_t i, const float* pp, const float* ff, double* uu, float* rr) {
      for (std::ptrdiff_t j = i; j < i + Floats::lanes; j += Doubles::lanes)
        fma(long_step, Doubles::load(pp + j), Doubles::load(uu + j)).store(uu + j);
      const Floats now = fma(step, Floats::load(ff + i), Floats::load(rr + i));
      now.store(rr + i);
      return now;
    };
    each_vector(bonds.grid, [&](std::ptrdiff_t i) {
      const Floats rx = component(i, p.x, f.x, u.x, r.x), ry = component(i, p.y, f.y, u.y, r.y);
      sum.add(rx, rx, ry, ry);
      const Floats xy = Floats::load(inverse.xy + i);
      (vb * fma(Floats::load(inverse.xx + i), rx, xy * ry)).store(z.x + i);
      (vb * fma(xy, rx, Floats::load(inverse.yy + i) * ry)).store(z.y + i);
    });
    return sum.value();
  }

  static double dot(const Bonds& bonds, Plane<const float> a, Plane<const float> b) {
    Sum<Machine> sum;
    each_vector(bonds.grid, [&](std::ptrdiff_t i) {
      sum.add(Floats::load(a.x + i), Floats::load(b.x + i), Floats::load(a.y + i), Floats::load(b.y + i));
    });
    return sum.value();
  }

  static void direct(const Bonds& bonds, float beta, Plane<const float> z, Plane<float> p) {
    const Floats keep = Floats(beta);
    each_vector(bonds.grid, [&](std::ptrdiff_t i) {
      fma(keep, Floats::load(p.x + i), Floats::load(z.x + i)).store(p.x + i);
      fma(keep, Floats::load(p.y + i), Floats::load(z.y + i)).store(p.y + i);
    });
  }

  static constexpr Kernels table(const char* name) {
    return {name,    force<Doubles>, force<Floats>,  imbalance, chebyshev, residual,
            stormer, relax,          conjugate_step, dot,       direct};
  }
};

/// The passes for every law that there is.
template <class Machine, class... Law> constexpr KernelSet every_law(const char* name, std::variant<Law...>*) {
  return {name, {Passes<Machine, Law>::table(name)...}};
}
template <class Machine> constexpr KernelSet kernel_set(const char* name) {
  return every_law<Machine>(name, static_cast<BondLawChoice*>(nullptr));
}

}  // namespace arenite::peridynamics
