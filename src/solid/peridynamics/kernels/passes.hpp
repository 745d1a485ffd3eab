#pragma once
#include <cstring>
#include <utility>

#include "solid/peridynamics/kernels/stencil.hpp"

namespace arenite::peridynamics {

/// The compiler's own vector type.
template <class T, int bytes> struct VectorOf { typedef T type __attribute__((vector_size(bytes))); };
template <class T, int bytes> using Vector = typename VectorOf<T, bytes>::type;

/// As many numbers as a vector of the machine holds. `Machine` says how wide its vectors are (`bytes`), how many
/// doubles a sum is kept in (`sum_lanes`) and how a vector is cut into as many (`doubles`), how a b + c is rounded
/// (`fma`), and how one of four moduli is found for every lane (`Words`, `Table`). Each is a type of its own source, in
/// an unnamed namespace, so that nothing compiled for one processor is ever linked into another's loops.
template <class Machine, class T> struct Lanes {
  using Scalar = T;
  static constexpr int lanes = Machine::bytes / static_cast<int>(sizeof(T));
  using V = Vector<T, Machine::bytes>;
  using Words = typename Machine::template Words<lanes>;
  using Table = typename Machine::template Table<Lanes>;
  typedef V Anywhere __attribute__((aligned(sizeof(T)), may_alias));
  V v;
  static Lanes load(const T* p) { return {*reinterpret_cast<const Anywhere*>(p)}; }
  static Lanes all(T c) { return {c - V{}}; }
  void store(T* p) const { *reinterpret_cast<Anywhere*>(p) = v; }
  friend Lanes operator+(Lanes a, Lanes b) { return {a.v + b.v}; }
  friend Lanes operator-(Lanes a, Lanes b) { return {a.v - b.v}; }
  friend Lanes operator*(Lanes a, Lanes b) { return {a.v * b.v}; }
  /// a b + c and c - a b.
  friend Lanes fma(Lanes a, Lanes b, Lanes c) { return {Machine::fma(a.v, b.v, c.v)}; }
  friend Lanes fnma(Lanes a, Lanes b, Lanes c) { return {Machine::fma(-a.v, b.v, c.v)}; }
};

/// Doubles kept in single precision.
template <class Doubles> void store_rough(Doubles a, float* p) {
  using Rough = Vector<float, sizeof(a.v) / 2>;
  const Rough rough = __builtin_convertvector(a.v, Rough);
  std::memcpy(p, &rough, sizeof rough);
}
template <class Doubles> Doubles load_rough(const float* p) {
  using Rough = Vector<float, sizeof(Doubles::v) / 2>;
  Rough rough;
  std::memcpy(&rough, p, sizeof rough);
  return {__builtin_convertvector(rough, typename Doubles::V)};
}

/// A sum of products a b of the two components of a plane field, in the doubles that the machine keeps sums in, lower
/// lanes first.
template <class Machine> class Sum {
 public:
  template <class V> void add(V ax, V bx, V ay, V by) {
    [&]<std::size_t... k>(std::index_sequence<k...>) {
      ((v_ = Machine::fma(Machine::template doubles<k>(ax.v), Machine::template doubles<k>(bx.v),
                          Machine::fma(Machine::template doubles<k>(ay.v), Machine::template doubles<k>(by.v), v_))),
       ...);
    }
    (std::make_index_sequence<V::lanes / n>());
  }
  double value() const {
    double p[n];
    std::memcpy(p, &v_, sizeof p);
    if constexpr (n == 2) return p[0] + p[1];
    else return (p[0] + p[1]) + (p[2] + p[3]);
  }

 private:
  static constexpr int n = Machine::sum_lanes;
  Vector<double, n * sizeof(double)> v_{};
};

/// The passes of Kernels for one machine and one law.
template <class Machine, BondLaw Law> struct Passes {
  using Doubles = Lanes<Machine, double>;
  using Floats = Lanes<Machine, float>;

  /// 1 where a component of a row is free to move, 0 where its displacement is prescribed.
  template <class V> static Force<V> freedom(std::uint8_t prescribed) {
    return {Stencil<V, Law>::all(prescribed & x_prescribed ? 0 : 1),
            Stencil<V, Law>::all(prescribed & y_prescribed ? 0 : 1)};
  }

  template <class V, class T = typename V::Scalar>
  static double force(const Bonds& bonds, const std::uint8_t* prescribed, Plane<const T> u, Plane<T> f) {
    Sum<Machine> sum;
    Force<V> open{};
    Stencil<V, Law>(bonds, u).sweep([&](int y) { open = freedom<V>(prescribed[y]); },
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
    Stencil<Doubles, Law>(bonds, u).sweep([&](int y) { open = freedom<Doubles>(prescribed[y]); },
                                          [&](std::ptrdiff_t i, Force<Doubles>, Force<Doubles> g) {
                                            g = {open.x * g.x, open.y * g.y};
                                            store_rough(g.x, r.x + i);
                                            store_rough(g.y, r.y + i);
                                            sum.add(g.x, g.x, g.y, g.y);
                                          });
    return sum.value();
  }

  static void chebyshev(const Bonds& bonds, Plane<const float> z, Plane<float> older, Plane<const float> r,
                        BlockPlane inverse, float a, float b) {
    using V = Floats;
    const V va = V::all(a), vb = V::all(b);
    Stencil<V, Law>(bonds, z).sweep(
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
    Stencil<V, Law>(bonds, z).sweep([](int) {},
                                    [&](std::ptrdiff_t i, Force<V>, Force<V> g) {
                                      (V::load(r.x + i) + g.x).store(out.x + i);
                                      (V::load(r.y + i) + g.y).store(out.y + i);
                                    });
  }

  static double stormer(const Bonds& bonds, const std::uint8_t* prescribed, Plane<const double> u, Plane<double> older,
                        double a, double b) {
    using V = Doubles;
    const V va = V::all(a), vb = V::all(b);
    Sum<Machine> sum;
    Force<V> open{};
    Stencil<V, Law>(bonds, u).sweep([&](int y) { open = freedom<V>(prescribed[y]); },
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
    const V va = V::all(a), vb = V::all(b);
    Sum<Machine> sum;
    Stencil<V, Law>(bonds, u).sweep([](int) {},
                                    [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
                                      __builtin_prefetch(older.x + i + bonds.grid.stride, 1);
                                      __builtin_prefetch(older.y + i + bonds.grid.stride, 1);
                                      const V xx = load_rough<Doubles>(inverse.xx + i),
                                              xy = load_rough<Doubles>(inverse.xy + i),
                                              yy = load_rough<Doubles>(inverse.yy + i);
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
    const Floats step = Floats::all(alpha), vb = Floats::all(b);
    const Doubles long_step = Doubles::all(static_cast<double>(alpha));
    Sum<Machine> sum;
    const auto component = [&](std::ptrdiff_t i, const float* pp, const float* ff, double* uu, float* rr) {
      for (std::ptrdiff_t j = i; j < i + Floats::lanes; j += Doubles::lanes)
        fma(long_step, load_rough<Doubles>(pp + j), Doubles::load(uu + j)).store(uu + j);
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
    const Floats keep = Floats::all(beta);
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
