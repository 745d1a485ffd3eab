// The passes of Kernels, written once over the lanes. Included after stencil.hpp, inside its target.
namespace {

/// 1 where a component of a row is free to move, 0 where its displacement is prescribed.
template <class V>
Force<V> freedom(std::uint8_t prescribed) {
  return {Stencil<V>::all(prescribed & x_prescribed ? 0 : 1), Stencil<V>::all(prescribed & y_prescribed ? 0 : 1)};
}

template <class V, class T = typename V::Scalar>
double force(const Bonds& bonds, const std::uint8_t* prescribed, Plane<const T> u, Plane<T> f) {
  Doubles sum = Doubles::all(0);
  Force<V> open{};
  Stencil<V>(bonds, u).sweep([&](int y) { open = freedom<V>(prescribed[y]); },
                             [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
                               g = {open.x * g.x, open.y * g.y};
                               g.x.store(f.x + i);
                               g.y.store(f.y + i);
                               sum = add_product(own.x, g.x, add_product(own.y, g.y, sum));
                             });
  return sum.sum();
}

void chebyshev(const Bonds& bonds, Plane<const float> z, Plane<float> older, Plane<const float> r, BlockPlane inverse,
               float a, float b) {
  using V = Floats;
  const V va = V::all(a), vb = V::all(b);
  Stencil<V>(bonds, z).sweep(
      [](int) {},
      [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
        const V rx = V::load(r.x + i) + g.x, ry = V::load(r.y + i) + g.y, xy = V::load(inverse.xy + i);
        const V dx = fma(V::load(inverse.xx + i), rx, xy * ry), dy = fma(xy, rx, V::load(inverse.yy + i) * ry);
        fma(vb, dx, fma(va, own.x - V::load(older.x + i), own.x)).store(older.x + i);
        fma(vb, dy, fma(va, own.y - V::load(older.y + i), own.y)).store(older.y + i);
      });
}

void residual(const Bonds& bonds, Plane<const float> z, Plane<const float> r, Plane<float> out) {
  using V = Floats;
  Stencil<V>(bonds, z).sweep([](int) {},
                             [&](std::ptrdiff_t i, Force<V>, Force<V> g) {
                               (V::load(r.x + i) + g.x).store(out.x + i);
                               (V::load(r.y + i) + g.y).store(out.y + i);
                             });
}

double stormer(const Bonds& bonds, const std::uint8_t* prescribed, Plane<const double> u, Plane<double> older, double a,
               double b) {
  using V = Doubles;
  const V va = V::all(a), vb = V::all(b);
  Doubles sum = Doubles::all(0);
  Force<V> open{};
  Stencil<V>(bonds, u).sweep([&](int y) { open = freedom<V>(prescribed[y]); },
                             [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
                               g = {open.x * g.x, open.y * g.y};
                               sum = fma(g.x, g.x, fma(g.y, g.y, sum));
                               fma(vb, g.x, fma(va, own.x - V::load(older.x + i), own.x)).store(older.x + i);
                               fma(vb, g.y, fma(va, own.y - V::load(older.y + i), own.y)).store(older.y + i);
                             });
  return sum.sum();
}

double relax(const Bonds& bonds, Plane<const double> u, Plane<double> older, BlockPlane inverse, double a, double b) {
  using V = Doubles;
  const V va = V::all(a), vb = V::all(b);
  Doubles sum = Doubles::all(0);
  Stencil<V>(bonds, u).sweep([](int) {},
                             [&](std::ptrdiff_t i, Force<V> own, Force<V> g) {
                               const V xx = load_rough(inverse.xx + i), xy = load_rough(inverse.xy + i),
                                       yy = load_rough(inverse.yy + i);
                               const V dx = fma(xx, g.x, xy * g.y), dy = fma(xy, g.x, yy * g.y);
                               sum = fma(dx, g.x, fma(dy, g.y, sum));
                               fma(vb, dx, fma(va, own.x - V::load(older.x + i), own.x)).store(older.x + i);
                               fma(vb, dy, fma(va, own.y - V::load(older.y + i), own.y)).store(older.y + i);
                             });
  return sum.sum();
}

/// All nodes of a grid, pads between the rows included: these hold zeros and stay so.
struct Span {
  std::ptrdiff_t begin, end;
};
Span span_of(const Grid& grid) { return {grid.row(0), grid.row(grid.height)}; }

double conjugate_step(const Bonds& bonds, double alpha, Plane<const double> p, Plane<const double> f, Plane<double> u,
                      Plane<double> r, BlockPlane inverse, float b, Plane<float> rough, Plane<float> z) {
  const Doubles step = Doubles::all(alpha);
  const Floats vb = Floats::all(b);
  Doubles sum = Doubles::all(0);
  const Span span = span_of(bonds.grid);
  const auto component = [&](const double* pp, const double* ff, double* uu, double* rr, float* out) {
    fma(step, Doubles::load(pp), Doubles::load(uu)).store(uu);
    const Doubles now = fma(step, Doubles::load(ff), Doubles::load(rr));
    now.store(rr);
    store_rough(now, out);
    sum = fma(now, now, sum);
  };
  for (std::ptrdiff_t i = span.begin; i < span.end; i += Floats::lanes) {
    for (std::ptrdiff_t j = i; j < i + Floats::lanes; j += Doubles::lanes) {
      component(p.x + j, f.x + j, u.x + j, r.x + j, rough.x + j);
      component(p.y + j, f.y + j, u.y + j, r.y + j, rough.y + j);
    }
    const Floats rx = Floats::load(rough.x + i), ry = Floats::load(rough.y + i), xy = Floats::load(inverse.xy + i);
    (vb * fma(Floats::load(inverse.xx + i), rx, xy * ry)).store(z.x + i);
    (vb * fma(xy, rx, Floats::load(inverse.yy + i) * ry)).store(z.y + i);
  }
  return sum.sum();
}

double dot(const Bonds& bonds, Plane<const float> a, Plane<const float> b) {
  Doubles sum = Doubles::all(0);
  const Span span = span_of(bonds.grid);
  for (std::ptrdiff_t i = span.begin; i < span.end; i += Floats::lanes)
    sum = add_product(Floats::load(a.x + i), Floats::load(b.x + i),
                      add_product(Floats::load(a.y + i), Floats::load(b.y + i), sum));
  return sum.sum();
}

void direct(const Bonds& bonds, double beta, Plane<const float> z, Plane<double> p) {
  const Doubles keep = Doubles::all(beta);
  const Span span = span_of(bonds.grid);
  for (std::ptrdiff_t i = span.begin; i < span.end; i += Doubles::lanes) {
    fma(keep, Doubles::load(p.x + i), load_rough(z.x + i)).store(p.x + i);
    fma(keep, Doubles::load(p.y + i), load_rough(z.y + i)).store(p.y + i);
  }
}

constexpr Kernels table_of(const char* name) {
  return {name, force<Doubles>, force<Floats>, chebyshev, residual, stormer, relax, conjugate_step, dot, direct};
}

}  // namespace
