#include "solid/peridynamics/space/bonds_in_space.hpp"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "solid/peridynamics/kernels/space_kernels.hpp"
#include "solid/peridynamics/space/load_in_space.hpp"
#include "support/element_samples.hpp"

namespace arenite::peridynamics {
namespace {

/// Stiffness of the lattice of one material for E = 1, by components of Voigt's tensor: exact sums over half bonds.
double lattice_modulus(int reach, std::array<int, 4> axes) {
  const auto k = bond_stiffness_in_space(reach);
  double sum = 0;
  std::size_t d = 0;
  each_half_bond_in_space(reach, [&](SpaceOffset e) {
    const std::array<int, 3> at{e.x, e.y, e.z};
    double product = k[d++];
    for (const int axis : axes) product *= at[static_cast<std::size_t>(axis)];
    sum += product;
  });
  return sum;
}

VoxelMap one_material(int width, int height, int depth) {
  VoxelMap map = make_voxel_map(width, height, depth, 1);
  map.phase.assign(map.size(), Phase::matrix);
  return map;
}

/// The places of a map's voxels, by their indices.
Vec3 place_of(const VoxelMap& map, std::size_t k) {
  const auto w = static_cast<std::size_t>(map.width), h = static_cast<std::size_t>(map.height);
  return {static_cast<double>(k % w), static_cast<double>(k / w % h), static_cast<double>(k / w / h)};
}

TEST(BondsInSpace, LatticeIsIsotropic) {
  for (const int reach : {2, 3}) {
    // E = 1 and nu = 1/4: C_1111 = 1.2, C_1122 = C_1212 = 0.4, which is isotropic as 1.2 - 0.4 = 2 * 0.4.
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3;
      EXPECT_NEAR(lattice_modulus(reach, {a, a, a, a}), 1.2, 1e-12);
      EXPECT_NEAR(lattice_modulus(reach, {a, a, b, b}), 0.4, 1e-12);
      EXPECT_NEAR(lattice_modulus(reach, {a, a, a, b}), 0, 1e-12);
    }
  }
  EXPECT_EQ(bond_stiffness_in_space(2).size(), 16u);
  EXPECT_EQ(bond_stiffness_in_space(3).size(), 61u);
  // The first half bonds are (1, 0, 0) and (2, 0, 0): c, and c w/8.
  EXPECT_NEAR(bond_stiffness_in_space(2)[0], 0.27083626, 1e-8);
  EXPECT_NEAR(bond_stiffness_in_space(2)[1] * 8 / 0.27083626, 0.6233537, 1e-7);
  EXPECT_NEAR(bond_stiffness_in_space(3)[0], 0.05125194, 1e-8);
}

TEST(BondsInSpace, UniformStrainHasHookesStressInside) {
  for (const int reach : {2, 3}) {
    const VoxelMap map = one_material(7, 8, 9);
    const SpaceBonds bonds = make_space_bonds(map, {5, 5, 5}, reach);
    statics::FieldIn<3, double> u(bonds.grid.padded_size()), f(bonds.grid.padded_size());
    std::size_t k = 0;
    bonds.grid.each([&](std::ptrdiff_t i, int) {
      const Vec3 at = place_of(map, k++);
      u.set(i, {0.01 * at.x + 0.003 * at.y, 0.002 * at.y, -0.004 * at.z + 0.006 * at.x});
    });
    const std::vector<std::uint8_t> free(9, statics::nothing_prescribed);
    const VoxelStress stress = node_stress(bonds, 1, u);
    const std::size_t inside = map.index(3, 4, 4);
    // lambda = mu = 0.4 E; single precision stores 1e-7 of 0.02.
    const double trace = 0.01 + 0.002 - 0.004, e = 5;
    EXPECT_NEAR(stress.xx[inside], 0.4 * e * (trace + 2 * 0.01), 1e-8);
    EXPECT_NEAR(stress.yy[inside], 0.4 * e * (trace + 2 * 0.002), 1e-8);
    EXPECT_NEAR(stress.zz[inside], 0.4 * e * (trace - 2 * 0.004), 1e-8);
    EXPECT_NEAR(stress.xy[inside], 0.4 * e * 0.003, 1e-8);
    EXPECT_NEAR(stress.xz[inside], 0.4 * e * 0.006, 1e-8);
    EXPECT_NEAR(stress.yz[inside], 0, 1e-8);
    for (const char* name : {"portable", "avx2", "avx512"})
      if (const auto* kernels = space_kernels_named(name, reach)) {
        kernels->force(bonds, free.data(), statics::pointers(std::as_const(u)), statics::pointers(f));
        for (const double component : {f.at(bonds.grid.index(3, 4, 4)).x, f.at(bonds.grid.index(3, 4, 4)).z})
          EXPECT_NEAR(component, 0, 1e-12);
      }
  }
}

/// Type of the bond between two voxels, from their labels alone.
unsigned type_between(const VoxelMap& map, std::size_t a, std::size_t b) {
  if (map.phase[a] == Phase::empty || map.phase[b] == Phase::empty) return 0;
  if (map.phase[a] != map.phase[b]) return 2;
  if (map.phase[a] == Phase::matrix) return 1;
  return map.grain[a] == map.grain[b] ? 3 : 2;
}

TEST(BondsInSpace, SolverFindsWhatDenseMatrixGives) {
  const VoxelMap whole = test::random_voxels(6, 5, 9);
  LoadOptions options;
  options.stiffness = {1, 0.5, 4};
  options.tolerance = 1e-9;
  options.strain = 0.01;
  for (const auto lower : {LowerEdge::fixed, LowerEdge::sliding})
    for (const int reach : {2, 3}) {
      options.horizon_in_space = reach;
      options.lower = lower;
      const auto loaded = load(whole, options);
      VoxelMap map = whole;  // without what hangs by bonds in one plane
      for (std::size_t k = 0; k < map.size(); ++k)
        if (loaded.field.xx[k] == 0 && loaded.field.yy[k] == 0 && loaded.field.zz[k] == 0)
          map.phase[k] = Phase::empty, map.grain[k] = -1;
      ASSERT_GT(loaded.report.support.carrying, map.size() / 2);
      ASSERT_EQ(loaded.report.ending, statics::Ending::solved) << loaded.report.sentence;
      EXPECT_LT(loaded.report.iterations, 40);
      EXPECT_NEAR(loaded.report.identity_defect, 0, 1e-6);
      // All pairs of voxels, with the stiffness of their distance.
      const auto n = static_cast<Eigen::Index>(3 * map.size());
      Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(n, n);
      const auto k = bond_stiffness_in_space(reach);
      const auto half = make_space_bonds(map, options.stiffness, reach).half;
      const std::array<double, 4> modulus{0, 1, 0.5, 4};
      for (std::size_t a = 0; a < map.size(); ++a)
        for (std::size_t b = 0; b < map.size(); ++b) {
          const Vec3 e = place_of(map, b) - place_of(map, a);
          for (std::size_t d = 0; d < half.size(); ++d) {
            if (e.x != half[d].x || e.y != half[d].y || e.z != half[d].z) continue;
            const Eigen::Vector3d v(e.x, e.y, e.z);
            const Eigen::Matrix3d block = modulus[type_between(map, a, b)] * k[d] * v * v.transpose();
            const auto i = static_cast<Eigen::Index>(3 * a), j = static_cast<Eigen::Index>(3 * b);
            matrix.block<3, 3>(i, i) += block, matrix.block<3, 3>(j, j) += block;
            matrix.block<3, 3>(i, j) -= block, matrix.block<3, 3>(j, i) -= block;
          }
        }
      Eigen::VectorXd right = Eigen::VectorXd::Zero(n);
      const auto layer = static_cast<Eigen::Index>(3 * map.width * map.height);
      const auto hold = [&](Eigen::Index row, double value) {
        right -= value * matrix.col(row);
        matrix.row(row).setZero(), matrix.col(row).setZero();
        matrix(row, row) = 1;
      };
      std::vector<std::pair<Eigen::Index, double>> held;
      for (Eigen::Index row = 0; row < layer; ++row) {
        if (lower == LowerEdge::fixed || row % 3 == 2) held.push_back({row, 0.0});
        held.push_back({n - layer + row, row % 3 == 2 ? options.strain * (map.depth - 1) * map.dx : 0.0});
      }
      for (const auto& [row, value] : held) hold(row, value);
      for (const auto& [row, value] : held) right(row) = value;
      for (Eigen::Index row = 0; row < n; ++row)  // voids, and what hangs on nothing
        if (matrix.row(row).cwiseAbs().maxCoeff() == 0) matrix(row, row) = 1;
      const Eigen::VectorXd u = matrix.ldlt().solve(right);
      const double top = options.strain * (map.depth - 1) * map.dx;
      for (std::size_t v = 0; v < map.size(); ++v)
        if (map.phase[v] != Phase::empty && loaded.field.zz[v] != 0) {
          const auto i = static_cast<Eigen::Index>(3 * v);
          EXPECT_NEAR(loaded.field.ux[v], u(i), 1e-5 * top);
          EXPECT_NEAR(loaded.field.uy[v], u(i + 1), 1e-5 * top);
          EXPECT_NEAR(loaded.field.uz[v], u(i + 2), 1e-5 * top);
        }
    }
}

TEST(BondsInSpace, ThinRodsAreSoft) {
  // Another implementation of this lattice: stiffness over that of a continuum 0.75, 0.87 and 0.93, to two digits, for
  // rods of 64 voxels; here the clamp above hinders contraction near one end.
  LoadOptions options;
  options.lower = LowerEdge::sliding;
  EXPECT_NEAR(load(one_material(2, 2, 64), options).report.modulus, 0.75, 0.01);
  EXPECT_NEAR(load(one_material(4, 4, 64), options).report.modulus, 0.87, 0.01);
  EXPECT_NEAR(load(one_material(8, 8, 64), options).report.modulus, 0.93, 0.01);
}

TEST(BondsInSpace, ChainsOfOneVoxelCarryNothing) {
  VoxelMap map = one_material(6, 6, 14);
  for (int z = 5; z < 10; ++z)
    for (int y = 0; y < 6; ++y)
      for (int x = 0; x < 6; ++x)
        if (x != 3 || y != 3) map.phase[map.index(x, y, z)] = Phase::empty;
  const auto loaded = load(map, {});
  EXPECT_EQ(loaded.report.ending, statics::Ending::severed) << loaded.report.sentence;
}

TEST(BondsInSpace, RefusesOneLayerAndOtherHorizons) {
  EXPECT_THROW(make_space_bonds(one_material(6, 6, 1), {}, 2), InputError);
  EXPECT_THROW(make_space_bonds(one_material(6, 6, 6), {}, 4), InputError);
}

}  // namespace
}  // namespace arenite::peridynamics
