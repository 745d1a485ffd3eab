#include "solid/peridynamics/kernels/kernels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>

#include "core/random.hpp"
#include "core/vec.hpp"
#include "support/cemented_sample.hpp"
#include "support/homogeneous_sample.hpp"

namespace arenite::peridynamics {
namespace {

PhaseMap sample() {
  test::CementedSample s;
  s.nodes = 77;  // no multiple of any lane count
  s.size_ratio = 2;
  return test::cemented_sample(s);
}

template <class T> Field<T> random_field(const Bonds& bonds, const PhaseMap& map) {
  Field<T> u(bonds.grid.padded_size());
  RandomStream random(7, Purpose::test);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      u.x[bonds.grid.index(x, y)] = static_cast<T>(random.uniform(-1, 1));
      u.y[bonds.grid.index(x, y)] = static_cast<T>(random.uniform(-1, 1));
    }
  return u;
}

/// Bond by bond, straight from the law.
Field<double> force_by_law(const Bonds& bonds, const Field<double>& u) {
  Field<double> f(bonds.grid.padded_size());
  for (int y = 0; y < bonds.grid.height; ++y)
    for (std::ptrdiff_t i = bonds.grid.row(y); i < bonds.grid.row(y) + bonds.grid.width; ++i)
      for (int d = 0; d < bonds_per_node; ++d) {
        const Offset e = half_bonds[static_cast<unsigned>(d)];
        const std::ptrdiff_t j = i + bonds.step(d);
        const double t = bonds.modulus(bonds.type(i, d)) * (e.x * (u.x[j] - u.x[i]) + e.y * (u.y[j] - u.y[i])) /
                         std::pow(length(e), 3);
        f.x[i] += t * e.x;
        f.y[i] += t * e.y;
        f.x[j] -= t * e.x;
        f.y[j] -= t * e.y;
      }
  return f;
}

class EveryKernel : public testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!kernels(GetParam())) GTEST_SKIP() << "this machine cannot run " << GetParam();
  }
  const Kernels& k() const { return *kernels(GetParam()); }
};

TEST_P(EveryKernel, ForceIsTheSumOverBonds) {
  const PhaseMap map = sample();
  const Bonds bonds = make_bonds(map, {});
  const std::vector<std::uint8_t> open(static_cast<std::size_t>(map.height), 0);
  const auto u = random_field<double>(bonds, map);
  Field<double> f(bonds.grid.padded_size());
  const double work = k().force(bonds, open.data(), pointers(u), pointers(f));
  const auto wanted = force_by_law(bonds, u);
  double sum = 0;
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const auto i = bonds.grid.index(x, y);
      ASSERT_NEAR(f.x[i], wanted.x[i], 1e-14 * 28) << x << " " << y;
      ASSERT_NEAR(f.y[i], wanted.y[i], 1e-14 * 28) << x << " " << y;
      sum += u.x[i] * wanted.x[i] + u.y[i] * wanted.y[i];
    }
  EXPECT_NEAR(work / sum, 1, 1e-13);
  EXPECT_LT(work, 0) << "bonds resist";
}

TEST_P(EveryKernel, SingleAndDoublePrecisionAgree) {
  const PhaseMap map = sample();
  const Bonds bonds = make_bonds(map, {});
  const std::vector<std::uint8_t> open(static_cast<std::size_t>(map.height), 0);
  const auto u = random_field<double>(bonds, map);
  const auto v = random_field<float>(bonds, map);
  Field<double> f(bonds.grid.padded_size());
  Field<float> g(bonds.grid.padded_size());
  k().force(bonds, open.data(), pointers(u), pointers(f));
  k().force_float(bonds, open.data(), pointers(v), pointers(g));
  for (std::ptrdiff_t i = bonds.grid.row(0); i < bonds.grid.row(map.height); ++i) ASSERT_NEAR(f.y[i], g.y[i], 1e-5);
}

TEST_P(EveryKernel, UniformStrainLeavesNoForceInside) {
  const PhaseMap map = test::homogeneous_sample(50, 30);
  const Bonds bonds = make_bonds(map, {});
  const std::vector<std::uint8_t> open(static_cast<std::size_t>(map.height), 0);
  Field<double> u(bonds.grid.padded_size()), f(bonds.grid.padded_size());
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      u.x[bonds.grid.index(x, y)] = 1e-3 * x - 2e-4 * y;
      u.y[bonds.grid.index(x, y)] = 3e-4 * x + 5e-4 * y;
    }
  k().force(bonds, open.data(), pointers(u), pointers(f));
  for (int y = 3; y < map.height - 3; ++y)
    for (int x = 3; x < map.width - 3; ++x) {
      ASSERT_NEAR(f.x[bonds.grid.index(x, y)], 0, 1e-16);
      ASSERT_NEAR(f.y[bonds.grid.index(x, y)], 0, 1e-16);
    }
}

TEST_P(EveryKernel, TurnedSampleHasTurnedForces) {
  const PhaseMap map = sample();
  const int n = map.width;
  PhaseMap turned = map;  // node (x, y) goes to (n - 1 - y, x)
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      turned.phase[map.index(n - 1 - y, x)] = map.phase[map.index(x, y)];
      turned.grain[map.index(n - 1 - y, x)] = map.grain[map.index(x, y)];
    }
  const Bonds bonds = make_bonds(map, {}), other = make_bonds(turned, {});
  const std::vector<std::uint8_t> open(static_cast<std::size_t>(n), 0);
  const auto u = random_field<double>(bonds, map);
  Field<double> v(bonds.grid.padded_size()), f(bonds.grid.padded_size()), g(bonds.grid.padded_size());
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      v.x[bonds.grid.index(n - 1 - y, x)] = -u.y[bonds.grid.index(x, y)];
      v.y[bonds.grid.index(n - 1 - y, x)] = u.x[bonds.grid.index(x, y)];
    }
  k().force(bonds, open.data(), pointers(u), pointers(f));
  k().force(other, open.data(), pointers(v), pointers(g));
  for (int y = 0; y < n; ++y)
    for (int x = 0; x < n; ++x) {
      ASSERT_NEAR(g.x[bonds.grid.index(n - 1 - y, x)], -f.y[bonds.grid.index(x, y)], 1e-13);
      ASSERT_NEAR(g.y[bonds.grid.index(n - 1 - y, x)], f.x[bonds.grid.index(x, y)], 1e-13);
    }
}

TEST_P(EveryKernel, PrescribedComponentsGetNoForce) {
  const PhaseMap map = sample();
  const Bonds bonds = make_bonds(map, {});
  std::vector<std::uint8_t> rows(static_cast<std::size_t>(map.height), 0);
  rows.front() = y_prescribed;
  rows.back() = both_prescribed;
  const auto u = random_field<double>(bonds, map);
  Field<double> f(bonds.grid.padded_size());
  k().force(bonds, rows.data(), pointers(u), pointers(f));
  double open_x = 0;
  for (int x = 0; x < map.width; ++x) {
    const auto low = bonds.grid.index(x, 0), high = bonds.grid.index(x, map.height - 1);
    ASSERT_EQ(f.y[low], 0);
    ASSERT_EQ(f.x[high], 0);
    ASSERT_EQ(f.y[high], 0);
    open_x += std::abs(f.x[low]);
  }
  EXPECT_GT(open_x, 0);
}

TEST_P(EveryKernel, ChebyshevAndResidualAndMotionAreForceAndArithmetic) {
  const PhaseMap map = sample();
  const Bonds bonds = make_bonds(map, {});
  const auto n = bonds.grid.padded_size();
  const std::vector<std::uint8_t> open(static_cast<std::size_t>(map.height), 0);
  const auto z = random_field<float>(bonds, map);
  Field<float> r(n), older(n), out(n), f(n);
  Buffer<float> xx(n), xy(n), yy(n);
  for (std::ptrdiff_t i = bonds.grid.row(0); i < bonds.grid.row(map.height); ++i) {
    r.x[i] = 0.5f * z.y[i];
    r.y[i] = -0.25f * z.x[i];
    older.x[i] = 2 * z.x[i];
    xx[i] = 0.5f;
    xy[i] = 0.125f;
    yy[i] = 0.25f;
  }
  k().force_float(bonds, open.data(), pointers(z), pointers(f));
  k().residual(bonds, pointers(z), pointers(r), pointers(out));
  k().chebyshev(bonds, pointers(z), pointers(older), pointers(r), {xx.data(), xy.data(), yy.data()}, 0.5f, 2.0f);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x) {
      const auto i = bonds.grid.index(x, y);
      const float rx = r.x[i] + f.x[i], ry = r.y[i] + f.y[i];
      ASSERT_NEAR(out.x[i], rx, 1e-6);
      ASSERT_NEAR(older.x[i], z.x[i] - 0.5f * z.x[i] + 2 * (0.5f * rx + 0.125f * ry), 2e-6);
      ASSERT_NEAR(older.y[i], 1.5f * z.y[i] + 2 * (0.125f * rx + 0.25f * ry), 2e-6);
    }
}

TEST_P(EveryKernel, StepOfConjugateGradientsIsItsArithmetic) {
  const PhaseMap map = sample();
  const Bonds bonds = make_bonds(map, {});
  const auto n = bonds.grid.padded_size();
  const std::vector<std::uint8_t> open(static_cast<std::size_t>(map.height), 0);
  const auto p = random_field<float>(bonds, map);
  auto u = random_field<double>(bonds, map);
  Field<float> f(n), r(n), z(n), q(n);
  Field<double> exact(n);
  Buffer<float> xx(n), xy(n), yy(n);
  for (std::ptrdiff_t i = bonds.grid.row(0); i < bonds.grid.row(map.height); ++i) {
    xx[i] = 0.5f;
    xy[i] = 0.125f;
    yy[i] = 0.25f;
    f.x[i] = 3 * p.y[i];
    f.y[i] = -p.x[i];
  }
  k().force(bonds, open.data(), pointers(u), pointers(exact));
  const double square = k().imbalance(bonds, open.data(), pointers(u), pointers(r));
  double wanted = 0, moved = 0, both = 0;
  for (std::ptrdiff_t i = bonds.grid.row(0); i < bonds.grid.row(map.height); ++i) {
    ASSERT_EQ(r.x[i], static_cast<float>(exact.x[i]));
    ASSERT_EQ(r.y[i], static_cast<float>(exact.y[i]));
    wanted += exact.x[i] * exact.x[i] + exact.y[i] * exact.y[i];
  }
  EXPECT_NEAR(square / wanted, 1, 1e-12);
  const Field<double> before = random_field<double>(bonds, map);
  const double after = k().conjugate_step(bonds, 0.5f, pointers(p), pointers(f), pointers(u), pointers(r),
                                          {xx.data(), xy.data(), yy.data()}, 2.0f, pointers(z));
  for (std::ptrdiff_t i = bonds.grid.row(0); i < bonds.grid.row(map.height); ++i) {
    ASSERT_EQ(u.x[i], before.x[i] + 0.5 * static_cast<double>(p.x[i]));
    ASSERT_NEAR(r.y[i], exact.y[i] - 0.5 * p.x[i], 1e-6);
    ASSERT_NEAR(z.x[i], 2 * (0.5f * r.x[i] + 0.125f * r.y[i]), 1e-6);
    ASSERT_NEAR(z.y[i], 2 * (0.125f * r.x[i] + 0.25f * r.y[i]), 1e-6);
    moved += static_cast<double>(r.x[i]) * r.x[i] + static_cast<double>(r.y[i]) * r.y[i];
    both += static_cast<double>(r.x[i]) * z.x[i] + static_cast<double>(r.y[i]) * z.y[i];
  }
  EXPECT_NEAR(after / moved, 1, 1e-12);
  EXPECT_NEAR(k().dot(bonds, pointers(r), pointers(z)) / both, 1, 1e-12);
  k().direct(bonds, -0.5f, pointers(z), pointers(q));
  for (std::ptrdiff_t i = bonds.grid.row(0); i < bonds.grid.row(map.height); ++i) ASSERT_EQ(q.x[i], z.x[i]);
  k().direct(bonds, -0.5f, pointers(p), pointers(q));
  for (std::ptrdiff_t i = bonds.grid.row(0); i < bonds.grid.row(map.height); ++i)
    ASSERT_NEAR(q.y[i], p.y[i] - 0.5f * z.y[i], 1e-6);
}

TEST(Kernels, WidestVectorsGiveTheSameBits) {
  const Kernels *narrow = kernels("avx2"), *wide = kernels("avx512");
  if (!narrow || !wide) GTEST_SKIP() << "this machine cannot run both";
  const PhaseMap map = sample();
  const Bonds bonds = make_bonds(map, {});
  const auto n = bonds.grid.padded_size();
  const std::vector<std::uint8_t> open(static_cast<std::size_t>(map.height), 0);
  const auto u = random_field<double>(bonds, map);
  const auto v = random_field<float>(bonds, map);
  Field<double> f(n), g(n);
  Field<float> a(n), b(n);
  EXPECT_EQ(narrow->force(bonds, open.data(), pointers(u), pointers(f)),
            wide->force(bonds, open.data(), pointers(u), pointers(g)));
  EXPECT_EQ(narrow->force_float(bonds, open.data(), pointers(v), pointers(a)),
            wide->force_float(bonds, open.data(), pointers(v), pointers(b)));
  EXPECT_EQ(narrow->dot(bonds, pointers(a), pointers(v)), wide->dot(bonds, pointers(b), pointers(v)));
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i) {
    ASSERT_EQ(f.x[i], g.x[i]);
    ASSERT_EQ(f.y[i], g.y[i]);
    ASSERT_EQ(a.x[i], b.x[i]);
    ASSERT_EQ(a.y[i], b.y[i]);
  }
  EXPECT_EQ(narrow->stormer(bonds, open.data(), pointers(u), pointers(f), 0.5, 0.25),
            wide->stormer(bonds, open.data(), pointers(u), pointers(g), 0.5, 0.25));
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(n); ++i) ASSERT_EQ(f.y[i], g.y[i]);
}

INSTANTIATE_TEST_SUITE_P(Machine, EveryKernel, testing::Values("portable", "avx2", "avx512"),
                         [](const auto& p) { return std::string(p.param); });

TEST(Kernels, UnknownNameIsNull) { EXPECT_EQ(kernels("abacus"), nullptr); }

}  // namespace
}  // namespace arenite::peridynamics
