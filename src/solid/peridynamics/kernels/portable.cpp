#include "core/processor.hpp"
#include "solid/peridynamics/kernels/passes.hpp"

namespace arenite::peridynamics {

extern const KernelSet* const avx2_kernels;  ///< null where the compiler cannot make them
extern const KernelSet* const avx512_kernels;

namespace {

/// What every x86-64 carries out: vectors of 16 bytes, products and sums rounded apart, so that the bits are the same
/// everywhere.
struct Portable {
  static constexpr int bytes = 16, sum_lanes = 2;
  template <std::size_t k> static Vector<double, 2> doubles(Vector<double, 2> a) { return a; }
  template <std::size_t k> static Vector<double, 2> doubles(Vector<float, 4> a) {
    return Vector<double, 2>{a[2 * k], a[2 * k + 1]};
  }
  template <int lanes> struct Words {
    std::uint32_t w[lanes];
    explicit Words(const std::uint32_t* p) { std::memcpy(w, p, sizeof w); }
  };
  /// Modulus by bond type: one of four floats, looked up by two bits of each word.
  template <class L> struct Table {
    typename L::Scalar four[4];
    explicit Table(const float* p) : four{p[0], p[1], p[2], p[3]} {}
    template <int shift> L find(Words<L::lanes> w) const {
      typename L::Scalar found[L::lanes];
      for (int i = 0; i < L::lanes; ++i) found[i] = four[w.w[i] >> shift & 3u];
      return L::load(found);
    }
  };
};

constexpr KernelSet portable = kernel_set<Portable>("portable");

KernelChoice<KernelSet> choice() { return {portable, avx2_kernels, avx512_kernels}; }

}  // namespace

const Kernels* kernels(const char* name, const BondLawChoice& law) {
  const KernelSet* set = choice().named(name);
  return set ? &set->by_law[law.index()] : nullptr;
}

const Kernels& kernels(const BondLawChoice& law) {
  static const KernelSet& best = choice().best();
  return best.by_law[law.index()];
}

}  // namespace arenite::peridynamics
