// Four floats or two doubles at once with the compiler's own vector types, which every machine can carry out.
#include <cstdint>
#include <cstring>

namespace {

/// Modulus by bond type: one of four floats, looked up by two bits of each word.
template <class Lanes>
struct PortableTable {
  typename Lanes::Scalar four[4];
  explicit PortableTable(const float* p) : four{p[0], p[1], p[2], p[3]} {}
  template <int shift>
  Lanes find(typename Lanes::Words w) const {
    typename Lanes::Scalar found[Lanes::lanes];
    for (int i = 0; i < Lanes::lanes; ++i) found[i] = four[w.w[i] >> shift & 3u];
    return Lanes::load(found);
  }
};

struct Doubles {
  using Scalar = double;
  static constexpr int lanes = 2;
  struct Words {
    std::uint32_t w[lanes];
  };
  using Table = PortableTable<Doubles>;
  using V = double __attribute__((vector_size(16)));
  V v;
  static Doubles load(const double* p) {
    Doubles d;
    std::memcpy(&d.v, p, sizeof d.v);
    return d;
  }
  static Doubles all(double c) { return {V{c, c}}; }
  void store(double* p) const { std::memcpy(p, &v, sizeof v); }
  static Words words(const std::uint32_t* p) { return {{p[0], p[1]}}; }
  friend Doubles operator+(Doubles a, Doubles b) { return {a.v + b.v}; }
  friend Doubles operator-(Doubles a, Doubles b) { return {a.v - b.v}; }
  friend Doubles operator*(Doubles a, Doubles b) { return {a.v * b.v}; }
  /// a b + c and c - a b, rounded twice: the same bits on every machine.
  friend Doubles fma(Doubles a, Doubles b, Doubles c) { return {a.v * b.v + c.v}; }
  friend Doubles fnma(Doubles a, Doubles b, Doubles c) { return {c.v - a.v * b.v}; }
};

struct Floats {
  using Scalar = float;
  static constexpr int lanes = 4;
  struct Words {
    std::uint32_t w[lanes];
  };
  using Table = PortableTable<Floats>;
  using V = float __attribute__((vector_size(16)));
  V v;
  static Floats load(const float* p) {
    Floats f;
    std::memcpy(&f.v, p, sizeof f.v);
    return f;
  }
  static Floats all(float c) { return {V{c, c, c, c}}; }
  void store(float* p) const { std::memcpy(p, &v, sizeof v); }
  static Words words(const std::uint32_t* p) { return {{p[0], p[1], p[2], p[3]}}; }
  friend Floats operator+(Floats a, Floats b) { return {a.v + b.v}; }
  friend Floats operator-(Floats a, Floats b) { return {a.v - b.v}; }
  friend Floats operator*(Floats a, Floats b) { return {a.v * b.v}; }
  friend Floats fma(Floats a, Floats b, Floats c) { return {a.v * b.v + c.v}; }
  friend Floats fnma(Floats a, Floats b, Floats c) { return {c.v - a.v * b.v}; }
};

/// A sum of products a b of the two components of a plane field.
class Sum {
 public:
  void add(Doubles ax, Doubles bx, Doubles ay, Doubles by) { v_ = fma(ax, bx, fma(ay, by, v_)); }
  void add(Floats ax, Floats bx, Floats ay, Floats by) {
    add(pair(ax, 0), pair(bx, 0), pair(ay, 0), pair(by, 0));
    add(pair(ax, 2), pair(bx, 2), pair(ay, 2), pair(by, 2));
  }
  double value() const { return v_.v[0] + v_.v[1]; }

 private:
  static Doubles pair(Floats f, int i) {
    return {Doubles::V{static_cast<double>(f.v[i]), static_cast<double>(f.v[i + 1])}};
  }
  Doubles v_ = Doubles::all(0);
};

inline void store_rough(Doubles a, float* p) {
  p[0] = static_cast<float>(a.v[0]);
  p[1] = static_cast<float>(a.v[1]);
}
inline Doubles load_rough(const float* p) { return {Doubles::V{static_cast<double>(p[0]), static_cast<double>(p[1])}}; }

}  // namespace
