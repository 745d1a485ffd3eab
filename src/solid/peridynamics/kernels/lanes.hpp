#pragma once
#include <cstring>
#include <utility>

namespace arenite::peridynamics {

/// The compiler's own vector type.
template <class T, int bytes> struct VectorOf { typedef T type __attribute__((vector_size(bytes))); };
template <class T, int bytes> using Vector = typename VectorOf<T, bytes>::type;

/// As many numbers as a vector of the machine holds. `Machine` says how wide its vectors are (`bytes`), how many doubles a sum is kept in (`sum_lanes`),
/// how a b + c is rounded (`fma`), and how one of four moduli is found for every lane (`Words`, `Table`). Each is a type of its own source, in an unnamed
/// namespace, so that nothing compiled for one processor is ever linked into another's loops.
template <class Machine, class T> struct Lanes {
  using Scalar = T;
  static constexpr int lanes = Machine::bytes / static_cast<int>(sizeof(T));
  using V = Vector<T, Machine::bytes>;
  using Words = typename Machine::template Words<lanes>;
  using Table = typename Machine::template Table<Lanes>;
  V v;
  static Lanes load(const T* p) {
    Lanes l;
    std::memcpy(&l.v, p, sizeof l.v);
    return l;
  }
  static Lanes all(T c) { return {c - V{}}; }
  void store(T* p) const { std::memcpy(p, &v, sizeof v); }
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

/// A sum of products a b of the two components of a plane field, in the doubles that the machine keeps sums in, lower lanes first.
template <class Machine> class Sum {
 public:
  template <class V> void add(V ax, V bx, V ay, V by) {
    [&]<std::size_t... k>(std::index_sequence<k...>) { ((v_ = Machine::fma(part<k>(ax), part<k>(bx), Machine::fma(part<k>(ay), part<k>(by), v_))), ...); }
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
  using D = Vector<double, n * sizeof(double)>;

  template <std::size_t k, class V> static D part(V a) {
    Vector<typename V::Scalar, n * sizeof(typename V::Scalar)> p;
    std::memcpy(&p, reinterpret_cast<const char*>(&a.v) + k * sizeof p, sizeof p);
    return __builtin_convertvector(p, D);
  }
  D v_{};
};

}  // namespace arenite::peridynamics
