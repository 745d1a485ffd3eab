#include "solid/elements/elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/elements/stress.hpp"
#include "solid/elements/support.hpp"
#include "support/cemented_sample.hpp"
#include "support/element_samples.hpp"

namespace arenite::elements {
namespace {

using statics::Field;
using Kernels = KernelsIn<2>;
using Matrix = std::vector<std::vector<double>>;
using test::alike;
using test::solid;

/// Elastic constants {C_11, C_12, C_66}, written apart from the program's.
std::array<double, 3> elastic(Constants c, PlaneState plane) {
  const double nu = plane == PlaneState::stress ? c.poisson : c.poisson / (1 - c.poisson),
               e = plane == PlaneState::stress ? c.young : c.young / (1 - c.poisson * c.poisson);
  return {e / (1 - nu * nu), e * nu / (1 - nu * nu), c.young / (2 * (1 + c.poisson))};
}

/// The stiffness of a unit square by 2 x 2 Gauss points, unknowns (u, v) of the corners (0,0), (1,0), (0,1), (1,1);
/// with `modes`, four incompatible ones behind them, condensed by Gaussian elimination.
Matrix by_quadrature(Constants constants, PlaneState plane, bool modes) {
  const auto [c11, c12, c66] = elastic(constants, plane);
  const std::size_t n = modes ? 12 : 8;
  Matrix k(n, std::vector<double>(n, 0));
  for (const double x : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)})
    for (const double y : {0.5 - std::sqrt(1.0 / 12), 0.5 + std::sqrt(1.0 / 12)}) {
      std::vector<std::array<double, 3>> strain;  // of a unit of each unknown: xx, yy, xy
      for (int corner = 0; corner < 4; ++corner) {
        const double gx = (corner & 1 ? 1 : -1) * (corner & 2 ? y : 1 - y),
                     gy = (corner & 2 ? 1 : -1) * (corner & 1 ? x : 1 - x);
        strain.push_back({gx, 0, gy});
        strain.push_back({0, gy, gx});
      }
      const double bx = 1 - 2 * x, by = 1 - 2 * y;  // slopes of x (1 - x) and y (1 - y)
      if (modes) strain.insert(strain.end(), {{bx, 0, 0}, {0, 0, bx}, {0, 0, by}, {0, by, 0}});
      for (std::size_t a = 0; a < n; ++a)
        for (std::size_t b = 0; b < n; ++b)
          k[a][b] +=
              0.25 * (strain[a][0] * (c11 * strain[b][0] + c12 * strain[b][1]) +
                      strain[a][1] * (c12 * strain[b][0] + c11 * strain[b][1]) + c66 * strain[a][2] * strain[b][2]);
    }
  for (std::size_t p = n; p-- > 8;)
    for (std::size_t a = 0; a < p; ++a)
      for (std::size_t b = 0; b < p; ++b) k[a][b] -= k[a][p] * k[p][b] / k[p][p];
  return k;
}

Field<double> applied(const Elements& elements, const Kernels& kernels, const Field<double>& u) {
  Field<double> f(elements.grid.padded_size());
  const std::vector<std::uint8_t> free(static_cast<std::size_t>(elements.grid.height), statics::nothing_prescribed);
  kernels.force(elements, free.data(), statics::pointers(u), statics::pointers(f));
  return f;
}

struct Case {
  Element element;
  PlaneState plane;
  double poisson;
};
std::vector<Case> cases() {
  std::vector<Case> all;
  for (const Element element : {Element::wilson, Element::full})
    for (const PlaneState plane : {PlaneState::stress, PlaneState::strain})
      for (const double nu : {-0.3, 0.0, 0.1, 0.3, 0.45}) all.push_back({element, plane, nu});
  return all;
}

TEST(Elements, OneIsTheMatrixThatQuadratureGives) {
  for (const auto& [element, plane, nu] : cases()) {
    const Constants constants{2.5, nu};
    const Matrix expected = by_quadrature(constants, plane, element == Element::wilson);
    const Elements one = make_elements<2>(solid(1, 1), alike(constants, element, plane));
    for (std::size_t b = 0; b < 8; ++b) {
      Field<double> u(one.grid.padded_size());
      const auto corner = [&](std::size_t c) {
        return one.grid.index(static_cast<int>(c & 1), static_cast<int>(c >> 1));
      };
      (b % 2 ? u.y : u.x)[static_cast<std::size_t>(corner(b / 2))] = 1;
      const Field<double> f = applied(one, kernels_of(one), u);
      for (std::size_t a = 0; a < 8; ++a) {
        const Vec2 at = f.at(corner(a / 2));
        EXPECT_NEAR(-(a % 2 ? at.y : at.x), expected[a][b], 1e-6) << "nu " << nu << ", " << a << " by " << b;
      }
    }
  }
}

TEST(Elements, ALinearFieldLeavesNoForceInsideAndTheStressOfHooke) {
  RandomStream random(3, Purpose::test);
  for (const auto& [element, plane, nu] : cases()) {
    const PhaseMap map = solid(37, 21);
    const Elements elements = make_elements<2>(map, alike({3, nu}, element, plane));
    double g[2][2];
    for (auto& row : g)
      for (double& v : row) v = random.uniform(-1, 1);
    Field<double> u(elements.grid.padded_size());
    for (int y = 0; y <= map.height; ++y)
      for (int x = 0; x <= map.width; ++x)
        u.set(elements.grid.index(x, y), {map.dx * (g[0][0] * x + g[0][1] * y), map.dx * (g[1][0] * x + g[1][1] * y)});
    const Field<double> f = applied(elements, kernels_of(elements), u);
    for (int y = 1; y < map.height; ++y)
      for (int x = 1; x < map.width; ++x) ASSERT_LT(norm(f.at(elements.grid.index(x, y))), 1e-15) << x << " " << y;
    const auto [c11, c12, c66] = elastic({3, nu}, plane);
    const StressField stress = element_stress<2>(map, elements, u);
    for (std::size_t k = 0; k < stress.size(); ++k) {
      ASSERT_NEAR(stress.xx[k], c11 * g[0][0] + c12 * g[1][1], 1e-6);
      ASSERT_NEAR(stress.yy[k], c12 * g[0][0] + c11 * g[1][1], 1e-6);
      ASSERT_NEAR(stress.xy[k], c66 * (g[0][1] + g[1][0]), 1e-6);
    }
  }
}

/// Energy of a strip of n elements across in pure bending, over that of a beam.
double bending(int n, double nu, Element element) {
  const int length = 12;
  const PhaseMap map = solid(length, n);
  const Elements elements = make_elements<2>(map, alike({1, nu}, element));
  Field<double> u(elements.grid.padded_size());
  for (int y = 0; y <= n; ++y)
    for (int x = 0; x <= length; ++x) {
      const double from_axis = y - 0.5 * n;
      u.set(elements.grid.index(x, y), {x * from_axis, -0.5 * (x * x + nu * from_axis * from_axis)});
    }
  const Field<double> f = applied(elements, kernels_of(elements), u);
  double energy = 0;
  elements.grid.each([&](std::ptrdiff_t i, int) { energy -= 0.5 * dot(u.at(i), f.at(i)); });
  return energy / (0.5 * length * n * n * n / 12.0);
}

TEST(Elements, WilsonsBendAsBeamsAndFullOnesAreStifferByOneOverTheSquareOfTheirNumber) {
  for (const double nu : {0.0, 0.25, 0.45})
    for (const int n : {1, 2, 3, 8}) {
      EXPECT_NEAR(bending(n, nu, Element::wilson), 1, 2e-6) << n;
      const double stiffer = 1 / (1 - nu * nu) + 1 / (2 * (1 + nu)) - 1;
      EXPECT_NEAR(bending(n, nu, Element::full), 1 + stiffer / (n * n), 2e-6) << n;
    }
}

/// A cemented sample with voids, matrix and touching grains.
struct Sample {
  PhaseMap map = test::cemented_sample({.nodes = 93, .size_ratio = 2.5, .bridge = 0.4});
  Elements elements = make_elements<2>(map, {{1, 0.3}, {2, 0.2}, {7, 0.4}});
};

Field<double> random_field(const Grid& grid) {
  RandomStream random(1, Purpose::test);
  Field<double> u(grid.padded_size());
  grid.each([&](std::ptrdiff_t i, int) { u.set(i, {random.uniform(-1, 1), random.uniform(-1, 1)}); });
  return u;
}

TEST(Elements, TheKernelsOfEveryMachineAgree) {
  const Sample s;
  const Field<double> u = random_field(s.elements.grid), f = applied(s.elements, *kernels_named<2>("portable"), u);
  std::vector<Field<double>> wide;
  for (const char* name : {"avx2", "avx512"}) {
    if (!kernels_named<2>(name)) continue;
    wide.push_back(applied(s.elements, *kernels_named<2>(name), u));
    s.elements.grid.each([&](std::ptrdiff_t i, int) { ASSERT_LT(norm(wide.back().at(i) - f.at(i)), 1e-13); });
  }
  if (wide.size() == 2) s.elements.grid.each([&](std::ptrdiff_t i, int) { ASSERT_EQ(wide[0].at(i), wide[1].at(i)); });
  EXPECT_EQ(kernels_named<2>("abacus"), nullptr);
}

TEST(Elements, TheBlockDiagonalIsWhatANodeFeelsOfItsOwnMotion) {
  const Sample s;
  const auto diagonal = block_diagonal(s.elements);
  for (const auto& [x, y] : {std::pair{20, 30}, {40, 41}, {0, 7}, {93, 93}, {61, 50}}) {
    const std::ptrdiff_t i = s.elements.grid.index(x, y);
    for (const Vec2 way : {Vec2{1, 0}, Vec2{0, 1}}) {
      Field<double> u(s.elements.grid.padded_size());
      u.set(i, way);
      const Vec2 f = applied(s.elements, kernels_of(s.elements), u).at(i);
      const Vec2 block{diagonal.xx[i] * way.x + diagonal.xy[i] * way.y,
                       diagonal.xy[i] * way.x + diagonal.yy[i] * way.y};
      EXPECT_LT(norm(f + block), 1e-12);
    }
  }
}

TEST(Elements, CouplingsAreTheEnergyOfWhatTheCoarseSpaceHolds) {
  for (const std::uint8_t bottom : {statics::both_prescribed, statics::y_prescribed}) {
    const Sample s;
    const Grid& grid = s.elements.grid;
    std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(grid.height), 0);
    prescribed.front() = bottom;
    prescribed.back() = statics::both_prescribed;
    const Aggregates aggregates = cut_into_aggregates<2>(s.map, s.elements, prescribed);
    RandomStream random(1, Purpose::test);
    std::vector<double> corner(8 * aggregates.list.size());
    for (double& c : corner) c = random.uniform(-1, 1);
    Field<double> u(grid.padded_size());
    for (int y = 0; y < grid.height; ++y)
      for (int x = 0; x < grid.width; ++x) {
        const std::ptrdiff_t i = grid.index(x, y);
        if (aggregates.of_node[i] < 0) continue;
        const auto p = static_cast<std::size_t>(aggregates.of_node[i]);
        Vec2 at;
        for (unsigned a = 0; a < 4; ++a)
          at += statics::hats_at(x, y)[a] * Vec2{corner[8 * p + 2 * a], corner[8 * p + 2 * a + 1]};
        if (prescribed[static_cast<std::size_t>(y)] == statics::y_prescribed) at.y = 0;
        u.set(i, at);
      }
    const Field<double> f = applied(s.elements, kernels_of(s.elements), u);
    double wanted = 0, found = 0;
    grid.each([&](std::ptrdiff_t i, int) { wanted -= dot(u.at(i), f.at(i)); });
    const auto sums = couplings(s.elements, aggregates, block_diagonal(s.elements), prescribed);
    sums.each(aggregates, [&](const statics::Coupling& c) {
      for (unsigned a = 0; a < 4; ++a)
        for (unsigned b = 0; b < 4; ++b) {
          const double* p = &corner[8 * static_cast<std::size_t>(c.p) + 2 * a];
          const double* q = &corner[8 * static_cast<std::size_t>(c.q) + 2 * b];
          found += (c.p == c.q ? 1 : 2) * (p[0] * (c.block[0][a][b] * q[0] + c.block[1][a][b] * q[1]) +
                                           p[1] * (c.block[2][a][b] * q[0] + c.block[3][a][b] * q[1]));
        }
    });
    EXPECT_NEAR(found / wanted, 1, 1e-10);
  }
}

TEST(Elements, NoFieldExceedsTheHighestRatio) {
  for (const double nu : {0.0, 0.25, 0.4, 0.49}) {
    const Elements elements = make_elements<2>(solid(40, 40), alike({1, nu}, Element::wilson, PlaneState::strain));
    const auto diagonal = block_diagonal(elements);
    const double highest = smoothing_of(elements).highest;
    Field<double> u = random_field(elements.grid);
    double ratio = 0;
    for (int round = 0; round < 300; ++round) {  // the power method on D^-1 K
      Field<double> f = applied(elements, kernels_of(elements), u);
      double up = 0, down = 0, square = 0;
      elements.grid.each([&](std::ptrdiff_t i, int) {
        const Vec2 own{diagonal.xx[i] * u.x[i] + diagonal.xy[i] * u.y[i],
                       diagonal.xy[i] * u.x[i] + diagonal.yy[i] * u.y[i]};
        up -= dot(u.at(i), f.at(i));
        down += dot(u.at(i), own);
        const double det = diagonal.xx[i] * diagonal.yy[i] - diagonal.xy[i] * diagonal.xy[i];
        f.set(i, -1 / det *
                     Vec2{diagonal.yy[i] * f.x[i] - diagonal.xy[i] * f.y[i],
                          diagonal.xx[i] * f.y[i] - diagonal.xy[i] * f.x[i]});
        square += dot(f.at(i), f.at(i));
      });
      ratio = up / down;
      elements.grid.each([&](std::ptrdiff_t i, int) { u.set(i, f.at(i) / std::sqrt(square)); });
    }
    EXPECT_LT(ratio, highest * (1 + 1e-6)) << nu;
    EXPECT_GT(ratio, 0.7 * highest) << nu;
  }
}

TEST(Elements, PixelsOfAGrainThatTouchAnotherAreInterface) {
  PhaseMap map = solid(6, 3, Phase::particle);
  map.grain_class = {GrainClass::none, GrainClass::none};
  for (int y = 0; y < 3; ++y)
    for (int x = 3; x < 6; ++x) map.grain[map.index(x, y)] = 1;
  const Elements elements = make_elements<2>(map, {});
  const Kind expected[] = {particle, particle, interface, interface, particle, particle};
  for (int x = 0; x < 6; ++x) EXPECT_EQ(elements.kind(elements.grid.index(x, 1)), expected[x]) << x;
}

TEST(ElementSupport, WhatHangsByACornerOrByNothingCarriesNothing) {
  PhaseMap map = make_phase_map(9, 9, 1e-3);
  const auto fill = [&](int x, int y) { map.phase[map.index(x, y)] = Phase::matrix; };
  for (int y = 0; y < 9; ++y) fill(1, y);  // a column
  fill(2, 5);                              // with a spur
  fill(3, 6);                              // which another pixel hangs on by a corner
  fill(6, 4);                              // an island
  fill(8, 0);                              // held below
  fill(8, 8);                              // held above
  Elements elements = make_elements<2>(map, {});
  Buffer<statics::Tie> tie;
  const statics::Support support = prune(elements, tie);
  EXPECT_EQ(support.solid, 14u);
  EXPECT_EQ(support.carrying, 10u);
  EXPECT_EQ(support.floating, 2u);
  EXPECT_EQ(support.islands, 2);
  EXPECT_EQ(support.held_below, 1u);
  EXPECT_EQ(support.held_above, 1u);
  EXPECT_EQ(elements.kind(elements.grid.index(3, 6)), none);
  EXPECT_EQ(elements.kind(elements.grid.index(2, 5)), matrix);
}

}  // namespace
}  // namespace arenite::elements
