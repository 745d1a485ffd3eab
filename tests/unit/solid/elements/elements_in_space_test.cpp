#include "solid/elements/elements.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/random.hpp"
#include "core/threads.hpp"
#include "solid/elements/kernels/kernels.hpp"
#include "solid/statics/halo.hpp"
#include "support/element_samples.hpp"

namespace arenite::elements::elements_in_space_test {
namespace {

using Matrix = std::vector<std::vector<double>>;
using Kernels = KernelsIn<3>;
template <class T> using Field = FieldIn<3, T>;
using test::alike;
using test::solid;

/// The stiffness of a unit cube by 2 x 2 x 2 Gauss points, unknowns (u, v, w) of the corners, x first; with `modes`,
/// nine incompatible ones behind them, condensed by Gaussian elimination.
Matrix by_quadrature(Constants constants, bool modes) {
  const auto [e, nu] = constants;
  const double mu = e / (2 * (1 + nu)), lambda = e * nu / ((1 + nu) * (1 - 2 * nu));
  const std::size_t n = modes ? 33 : 24;
  Matrix k(n, std::vector<double>(n, 0));
  const double low = 0.5 - std::sqrt(1.0 / 12);
  for (int point = 0; point < 8; ++point) {
    const std::array<double, 3> at{point & 1 ? 1 - low : low, point & 2 ? 1 - low : low, point & 4 ? 1 - low : low};
    std::vector<std::array<std::array<double, 3>, 3>> gradient;  // of a unit of each unknown: [component][axis]
    for (int corner = 0; corner < 8; ++corner)
      for (std::size_t c = 0; c < 3; ++c) {
        gradient.push_back({});
        for (std::size_t axis = 0; axis < 3; ++axis) {
          double g = 1;
          for (std::size_t other = 0; other < 3; ++other) {
            const bool far = corner >> other & 1;
            if (other == axis) g *= far ? 1 : -1;
            else g *= far ? at[other] : 1 - at[other];
          }
          gradient.back()[c][axis] = g;
        }
      }
    for (std::size_t c = 0; modes && c < 3; ++c)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        gradient.push_back({});
        gradient.back()[c][axis] = 1 - 2 * at[axis];  // slope of x (1 - x)
      }
    for (std::size_t a = 0; a < n; ++a)
      for (std::size_t b = 0; b < n; ++b) {
        double trace_a = 0, trace_b = 0, product = 0;
        for (std::size_t i = 0; i < 3; ++i) {
          trace_a += gradient[a][i][i];
          trace_b += gradient[b][i][i];
          for (std::size_t j = 0; j < 3; ++j)
            product += (gradient[a][i][j] + gradient[a][j][i]) * (gradient[b][i][j] + gradient[b][j][i]) / 4;
        }
        k[a][b] += 0.125 * (lambda * trace_a * trace_b + 2 * mu * product);
      }
  }
  for (std::size_t p = n; p-- > 24;)
    for (std::size_t a = 0; a < p; ++a)
      for (std::size_t b = 0; b < p; ++b) k[a][b] -= k[a][p] * k[p][b] / k[p][p];
  return k;
}

Field<double> applied(const Voxels& voxels, const Kernels& kernels, const Field<double>& u) {
  Field<double> f(voxels.grid.padded_size());
  const std::vector<std::uint8_t> free(static_cast<std::size_t>(voxels.grid.levels()), statics::nothing_prescribed);
  kernels.force(voxels, free.data(), statics::pointers(u), statics::pointers(f));
  return f;
}

TEST(Voxels, OneIsTheMatrixThatQuadratureGives) {
  for (const Element element : {Element::wilson, Element::full})
    for (const double nu : {-0.3, 0.0, 0.1, 0.3, 0.45}) {
      const Matrix expected = by_quadrature({2.5, nu}, element == Element::wilson);
      const Voxels one = make_elements<3>(solid(1, 1, 1), alike({2.5, nu}, element));
      const auto steps = one.steps();
      const std::ptrdiff_t i = one.grid.index(0, 0, 0);
      for (std::size_t b = 0; b < 24; ++b) {
        Field<double> u(one.grid.padded_size());
        u[static_cast<int>(b % 3)][i + steps[b / 3]] = 1;
        const Field<double> f = applied(one, kernels_of(one), u);
        for (std::size_t a = 0; a < 24; ++a)  // single precision keeps 7 digits of each constant
          ASSERT_NEAR(-f[static_cast<int>(a % 3)][i + steps[a / 3]], expected[a][b], 2e-7 * 2.5)
              << nu << " " << a << " " << b;
      }
    }
}

TEST(Voxels, BlocksOfCornersAreWhatTheKernelGives) {
  const Voxels one = make_elements<3>(solid(1, 1, 1), alike({2.5, 0.3}));
  const Matrix expected = by_quadrature({2.5, 0.3}, true);
  for (int c = 0; c < 8; ++c)
    for (int d = 0; d < 8; ++d) {
      const auto block = corner_block<3>(one.modes[matrix], c, d);
      for (std::size_t a = 0; a < 3; ++a)
        for (std::size_t b = 0; b < 3; ++b)
          EXPECT_NEAR(block[a][b], expected[static_cast<std::size_t>(3 * c) + a][static_cast<std::size_t>(3 * d) + b],
                      1e-6);
    }
}

TEST(Voxels, LinearFieldsLeaveNoForceInside) {
  const Voxels voxels = make_elements<3>(solid(37, 9, 6), alike({1, 0.3}));
  Field<double> u(voxels.grid.padded_size());
  for (int z = 0; z < voxels.grid.depth; ++z)
    for (int y = 0; y < voxels.grid.height; ++y)
      for (int x = 0; x < voxels.grid.width; ++x)
        u.set(voxels.grid.index(x, y, z), {0.1 * x - 0.2 * y + 0.3 * z, 0.4 * x + 0.5 * y, 0.6 * y - 0.7 * z});
  const Field<double> f = applied(voxels, kernels_of(voxels), u);
  double inside = 0, surface = 0;
  for (int z = 0; z < voxels.grid.depth; ++z)
    for (int y = 0; y < voxels.grid.height; ++y)
      for (int x = 0; x < voxels.grid.width; ++x) {
        const bool in = x > 0 && y > 0 && z > 0 && x < 37 && y < 9 && z < 6;
        double& largest = in ? inside : surface;
        largest = std::max(largest, norm(f.at(voxels.grid.index(x, y, z))));
      }
  EXPECT_GT(surface, 0.1);
  EXPECT_LT(inside, 1e-14 * 40);  // rounding of displacements of some 20
}

/// A sample with voids and two grains, wider than a tile of every kernel.
Voxels mixed(bool periodic = false) {
  return make_elements<3>(test::random_voxels(150, 11, 9), test::two_phases(), periodic);
}

Field<double> noise(const Grid& grid, std::uint64_t seed) {
  Field<double> u(grid.padded_size());
  RandomStream random(seed, Purpose::test);
  grid.each([&](std::ptrdiff_t i, int) {
    u.set(i, {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)});
  });
  return u;
}

TEST(Voxels, TheKernelIsTheSumOfVoxels) {
  for (const bool periodic : {false, true}) {
    const Voxels voxels = mixed(periodic);
    Field<double> u = noise(voxels.grid, 1), expected(voxels.grid.padded_size());
    statics::close_period(voxels.grid, u);
    for (int z = 0; z < voxels.cells[2]; ++z)
      for (int y = 0; y < voxels.cells[1]; ++y)
        for (int x = 0; x < voxels.cells[0]; ++x) {
          const Kind kind = voxels.kind(voxels.grid.index(x, y, z));
          if (kind == none) continue;
          const auto node = [&](int c) { return voxels.node(x + (c & 1), y + (c >> 1 & 1), z + (c >> 2)); };
          for (int c = 0; c < 8; ++c)
            for (int d = 0; d < 8; ++d) {
              const auto block = corner_block<3>(voxels.modes[kind], c, d);
              for (int a = 0; a < 3; ++a)
                for (int b = 0; b < 3; ++b)
                  expected[a][node(c)] -=
                      block[static_cast<std::size_t>(a)][static_cast<std::size_t>(b)] * u[b][node(d)];
            }
        }
    for (const char* name : {"portable", "avx2", "avx512"}) {
      const Kernels* kernels = kernels_named<3>(name);
      if (!kernels) continue;
      const Field<double> f = applied(voxels, *kernels, u);
      voxels.grid.each([&](std::ptrdiff_t i, int) { ASSERT_LT(norm(f.at(i) - expected.at(i)), 1e-12) << name; });
    }
  }
}

TEST(Voxels, TheBlockDiagonalIsWhatANodeFeelsOfItsOwnMotion) {
  const Voxels voxels = mixed();
  const auto diagonal = block_diagonal(voxels);
  for (const auto [x, y, z] : {std::array{3, 4, 5}, std::array{149, 0, 0}, std::array{70, 11, 9}}) {
    const std::ptrdiff_t i = voxels.grid.index(x, y, z);
    for (int b = 0; b < 3; ++b) {
      Field<double> u(voxels.grid.padded_size());
      u[b][i] = 1;
      const Field<double> f = applied(voxels, kernels_of(voxels), u);
      for (int a = 0; a < 3; ++a) EXPECT_NEAR(-f[a][i], diagonal(a, b)[i], 1e-13);
    }
  }
}

/// The energy of random values at the corners of all aggregates by the Galerkin sums, over that of their field by the
/// kernel.
double ratio_of_energies(const VoxelMap& map, const std::vector<std::uint8_t>& prescribed, int side, bool periodic,
                         const ThreadPool* pool = nullptr) {
  const Voxels voxels = make_elements<3>(map, test::two_phases(), periodic, pool);
  const Aggregates cut = cut_into_aggregates<3>(map, voxels, prescribed, side);
  RandomStream random(3, Purpose::test);
  std::vector<std::array<Vec3, 8>> corner(cut.list.size());
  for (auto& values : corner)
    for (Vec3& v : values) v = {random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
  const statics::HatTableIn<3> hats(side);
  Field<double> u(voxels.grid.padded_size());
  for (int z = 0; z < voxels.grid.depth; ++z)
    for (int y = 0; y < voxels.grid.height; ++y)
      for (int x = 0; x < voxels.grid.width; ++x) {
        const std::ptrdiff_t i = voxels.grid.index(x, y, z);
        const std::int32_t p = cut.of_node[i];
        if (p < 0) continue;
        Vec3 at;
        for (int a = 0; a < 8; ++a)
          at += hats.at(x, y, z)[a] * corner[static_cast<std::size_t>(p)][static_cast<std::size_t>(a)];
        if (prescribed[static_cast<std::size_t>(z)] == statics::z_prescribed) at.z = 0;
        u.set(i, at);
      }
  statics::close_period(voxels.grid, u);
  double wanted = 0;
  const Field<double> f = applied(voxels, kernels_of(voxels), u);
  voxels.grid.each([&](std::ptrdiff_t i, int) { wanted -= dot(u.at(i), f.at(i)); });
  double found = 0;
  couplings(voxels, cut, block_diagonal(voxels), prescribed).each(cut, [&](const statics::CouplingIn<3>& c) {
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        for (int a = 0; a < 8; ++a)
          for (int b = 0; b < 8; ++b)
            found += (c.p == c.q ? 1 : 2) *
                     c.block[static_cast<std::size_t>(3 * i + j)][static_cast<std::size_t>(a)][b] *
                     corner[static_cast<std::size_t>(c.p)][static_cast<std::size_t>(a)][i] *
                     corner[static_cast<std::size_t>(c.q)][static_cast<std::size_t>(b)][j];
  });
  return found / wanted;
}

/// A tenth of the voxels of cemented spheres are another's: void, matrix or one of the spheres.
VoxelMap mottled_spheres() {
  VoxelMap map = test::cemented_spheres(30, true);
  RandomStream random(4, Purpose::test);
  for (std::size_t k = 0; k < map.size(); ++k) {
    if (random.uniform(0, 1) > 0.1) continue;
    map.phase[k] = static_cast<Phase>(static_cast<int>(random.uniform(0, 3)));
    map.grain[k] = map.phase[k] == Phase::particle
                       ? static_cast<int>(random.uniform(0, static_cast<double>(map.grain_class.size())))
                       : -1;
  }
  return map;
}

TEST(Voxels, TheEnergyOfHatsIsTheEnergyOfVoxels) {
  const ThreadPool three(3);
  // Elements that are cut by grains, those that are not, and both in one cell.
  const std::vector<VoxelMap> maps{test::random_voxels(21, 13, 10), test::cemented_spheres(29, false),
                                   mottled_spheres()};
  for (const VoxelMap& map : maps)
    for (const int side : {2, 3, 4, 8})
      for (const std::uint8_t bottom : {statics::z_prescribed, statics::all_prescribed}) {
        std::vector<std::uint8_t> prescribed(static_cast<std::size_t>(map.depth + 1), statics::nothing_prescribed);
        prescribed.front() = bottom;
        prescribed.back() = statics::all_prescribed;
        EXPECT_NEAR(ratio_of_energies(map, prescribed, side, false), 1, 1e-11) << map.width << " " << side;
        EXPECT_NEAR(ratio_of_energies(map, prescribed, side, false, &three), 1, 1e-11) << map.width << " " << side;
      }
  const std::vector<std::uint8_t> free(30, statics::nothing_prescribed);
  for (const int side : {3, 5, 6, 10}) EXPECT_NEAR(ratio_of_energies(maps[2], free, side, true), 1, 1e-11) << side;
}

}  // namespace
}  // namespace arenite::elements::elements_in_space_test
