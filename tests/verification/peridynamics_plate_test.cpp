// Homogeneous samples against the lattice's own numbers (exact sums or long strips) and against closed forms.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "solid/peridynamics/lattice.hpp"
#include "solid/peridynamics/load.hpp"
#include "support/homogeneous_sample.hpp"
#include "support/lattice_moduli.hpp"

namespace arenite::peridynamics {
namespace {

LoadResult pull(const PhaseMap& map, LoadOptions options = {}) {
  options.tolerance = 1e-9;
  auto result = load(map, options);
  EXPECT_EQ(result.report.ending, Ending::solved) << result.report.sentence;
  return result;
}

double row_mean(const StressField& field, int y) {
  double sum = 0;
  for (int x = 0; x < field.width; ++x) sum += field.yy[static_cast<std::size_t>(y * field.width + x)];
  return sum / field.width;
}

/// Axial strain between two rows about the middle.
double strain_in_the_middle(const StressField& field) {
  const int low = field.height / 2 - 10, high = field.height / 2 + 10;
  double sum = 0;
  for (int x = 0; x < field.width; ++x)
    sum += field.uy[static_cast<std::size_t>(high * field.width + x)] -
           field.uy[static_cast<std::size_t>(low * field.width + x)];
  return sum / (field.width * (high - low) * field.dx);
}

TEST(LongStrip, ModulusFallsWithWidthByTheLatticesEdgeLaw) {
  for (const int width : {16, 32}) {
    const auto result = pull(test::homogeneous_sample(width, 10 * width));
    const double stress = result.report.top_force.y / (width * result.field.dx);
    EXPECT_NEAR(stress / strain_in_the_middle(result.field), 1 - 0.5669 / width, 2e-5) << width;
  }
}

TEST(LongStrip, StressFallsTowardsAFreeEdge) {
  const int width = 64, height = 512;
  const auto field = pull(test::homogeneous_sample(width, height)).field;
  const auto* row = &field.yy[static_cast<std::size_t>(height / 2 * width)];
  const double factors[6] = {0.7803, 0.9433, 0.9922, 1.0006, 1.0003, 0.9999};
  for (int k = 0; k < 6; ++k) {
    EXPECT_NEAR(row[k] / row[width / 2], factors[k], 1e-4) << k;
    EXPECT_NEAR(row[width - 1 - k] / row[k], 1, 1e-6) << k;
  }
}

TEST(LongStrip, ContractsByTheLatticesPoissonRatio) {
  const int width = 64, height = 512;
  const auto field = pull(test::homogeneous_sample(width, height)).field;
  const auto at = [&](int x) { return field.ux[static_cast<std::size_t>(height / 2 * width + x)]; };
  const double lateral = (at(width / 2 + 8) - at(width / 2 - 8)) / (16 * field.dx);
  EXPECT_NEAR(-lateral / strain_in_the_middle(field), lattice_moduli().poisson_axis, 2e-4);
}

TEST(Clamp, RowMeansNearAOneRowClamp) {
  const auto field = pull(test::homogeneous_sample(1024, 1024)).field;
  double mean = 0;
  for (int y = 0; y < field.height; ++y) mean += row_mean(field, y) / field.height;
  const double rows[6] = {0.8505, 0.6276, 1.0144, 1.0167, 0.9937, 1.0029};
  for (int k = 0; k < 6; ++k) EXPECT_NEAR(row_mean(field, k) / mean, rows[k], 1e-4) << k;
}

TEST(Plate, NominalMicromodulusIsStifferByTheLatticesFactor) {
  const PhaseMap map = test::homogeneous_sample(24, 48);
  LoadOptions nominal;
  nominal.stiffness.calibrated = false;
  EXPECT_NEAR(pull(map, nominal).report.modulus / pull(map).report.modulus, 1 / calibration_factor(), 1e-9);
}

TEST(Plate, ParticleIsStifferThanMatrixByTheRatioOfModuli) {
  EXPECT_NEAR(pull(test::homogeneous_sample(24, 48, Phase::particle)).report.modulus /
                  pull(test::homogeneous_sample(24, 48)).report.modulus,
              4, 1e-8);
}

PhaseMap two_blocks(int side, bool in_series) {
  PhaseMap map = test::homogeneous_sample(side, side);
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x)
      if ((in_series ? y : x) >= side / 2) {
        map.phase[map.index(x, y)] = Phase::particle;
        map.grain[map.index(x, y)] = 0;
      }
  return map;
}

TEST(TwoBlocks, SideBySideCarryTheMeanOfTheirModuliAndInRowTheHarmonicMean) {
  // But for the seam, where the softer block hinders the other's contraction.
  const int side = 192;
  const double whole = pull(test::homogeneous_sample(side, side)).report.modulus;
  EXPECT_NEAR(pull(two_blocks(side, false)).report.modulus / whole, 2.5, 0.01 * 2.5);
  EXPECT_NEAR(pull(two_blocks(side, true)).report.modulus / whole, 1.6, 0.01 * 1.6);
}

TEST(Hole, StressBesideItFollowsKirschAndComesCloserOnAFinerGrid) {
  double last = 1;
  for (const int side : {161, 321}) {
    PhaseMap map = test::homogeneous_sample(side, side);
    const int middle = side / 2;
    double nodes = 0;
    for (int y = 0; y < side; ++y)
      for (int x = 0; x < side; ++x)
        if (std::hypot(x - middle, y - middle) < side / 32.0) {
          map.phase[map.index(x, y)] = Phase::empty;
          nodes += 1;
        }
    const double radius = std::sqrt(nodes / std::numbers::pi);  // of the disk of equal area
    const auto result = pull(map);
    const auto whole = pull(test::homogeneous_sample(side, side));
    double worst = 0;
    for (const double distance : {1.5, 2.0, 2.5}) {
      const int x = middle + static_cast<int>(std::lround(distance * radius));
      const double q = radius / (x - middle), kirsch = 1 + q * q / 2 + 1.5 * std::pow(q, 4);
      const auto i = map.index(x, middle);
      worst = std::max(worst, std::abs(result.field.yy[i] / whole.field.yy[i] / kirsch - 1));
    }
    EXPECT_LT(worst, 0.6 * last) << side;
    last = worst;
  }
  EXPECT_LT(last, 0.015);
}

}  // namespace
}  // namespace arenite::peridynamics
