#include "solid/peridynamics/measures.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <utility>

#include "solid/peridynamics/damage.hpp"

namespace arenite::peridynamics {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Stretch at which a crack through bonds of horizon 3 dx takes K^2/E: sqrt(4 pi K^2/(9 E^2 h)), in plane stress.
double of_fracture(double toughness, double modulus, double dx) {
  return toughness / modulus * std::sqrt(4 * pi / (9 * 3 * dx));
}

TEST(BreakingLimits, AreThoseOfFractureMechanicsWithoutStrength) {
  DamageOptions options;
  options.stiffness = {1e9, 2e9, 4e9};
  options.toughness = {1e5, 1e5, 3.5e5};
  const BreakingLimits limits = breaking_limits(options, 1e-4);
  EXPECT_NEAR(limits.stretch[matrix_bond] / of_fracture(1e5, 1e9, 1e-4), 1, 1e-12);
  EXPECT_NEAR(limits.stretch[interface_bond] / of_fracture(1e5, 2e9, 1e-4), 1, 1e-12);
  EXPECT_NEAR(limits.stretch[particle_bond] / of_fracture(3.5e5, 4e9, 1e-4), 1, 1e-12);
  for (const unsigned type : {matrix_bond, interface_bond, particle_bond})
    EXPECT_EQ(limits.set_by[type], Limit::toughness);
  EXPECT_TRUE(limits.follow_spacing());
}

TEST(BreakingLimits, PassFromToughnessToStrengthAtIrwinsSpacing) {
  // K sqrt(4 pi/(27 dx)) is the strength f at dx = 4 pi K^2/(27 f^2): below it bonds are stronger than f.
  DamageOptions options;
  options.stiffness = {1e9, 1e9, 1e9};
  options.toughness = {1e5, 1e5, 1e5};
  options.strength = {2e6, 2e6, HUGE_VAL};
  const double spacing = 4 * pi * 1e10 / (27 * 4e12);
  const BreakingLimits coarse = breaking_limits(options, 1.01 * spacing), fine = breaking_limits(options, spacing / 4);
  EXPECT_EQ(coarse.set_by[matrix_bond], Limit::toughness);
  EXPECT_TRUE(coarse.follow_spacing());
  EXPECT_EQ(fine.set_by[matrix_bond], Limit::strength);
  EXPECT_DOUBLE_EQ(fine.stretch[matrix_bond], 2e6 / 1e9);
  EXPECT_EQ(fine.set_by[particle_bond], Limit::toughness);
  EXPECT_FALSE(fine.follow_spacing()) << "grains outlast what is between them";
}

TEST(BrokenByType, CountsEachBondOnce) {
  const auto bond = [](BondType type) { return BrokenBond{0, 0, 0, 0, static_cast<std::uint8_t>(type), 0}; };
  const auto count = broken_by_type({bond(particle_bond), bond(matrix_bond), bond(particle_bond)});
  EXPECT_EQ(count, (std::array<std::size_t, 4>{0, 1, 0, 2}));
}

TEST(StrainAtStrength, IsThatOfTheLargestStress) {
  FailureRecord test;
  EXPECT_FALSE(strain_at_strength(test));
  for (const auto& [strain, stress] : {std::pair{1e-3, 2.0}, {2e-3, 4.0}, {3e-3, 3.0}})
    test.curve.push_back({.strain = strain, .stress = stress});
  test.strength = 4;
  EXPECT_EQ(strain_at_strength(test), 2e-3);
}

/// Two blocks of matrix with `gap` rows of void between them, crossed by a column of matrix or none.
PhaseMap parted(int gap, bool is_crossed) {
  PhaseMap map = make_phase_map(12, 12 + gap, 1);
  for (int y = 0; y < map.height; ++y)
    for (int x = 0; x < map.width; ++x)
      if (y < 6 || y >= 6 + gap || (is_crossed && x == 4)) map.phase[map.index(x, y)] = Phase::matrix;
  return map;
}

TEST(JoinedThroughVoidsOnly, WhereACrackIsThinnerThanBondsAreLong) {
  // Bonds reach three nodes: across two rows of void, not across three.
  EXPECT_FALSE(joined_through_voids_only(parted(0, false)));
  EXPECT_TRUE(joined_through_voids_only(parted(1, false)));
  EXPECT_TRUE(joined_through_voids_only(parted(2, false)));
  EXPECT_FALSE(joined_through_voids_only(parted(3, false)));
  EXPECT_FALSE(joined_through_voids_only(parted(2, true)));
}

TEST(BrokenAfterSteps, CountsThoseOfOneTypeUpToEachStep) {
  const std::vector<std::uint8_t> types{1, 1, 2, 1, 3};
  const std::vector<double> of_any_type{0, 2, 3, 3, 5};
  EXPECT_EQ(broken_after_steps(types, of_any_type, 1), (std::vector<double>{0, 2, 2, 2, 3}));
  EXPECT_EQ(broken_after_steps(types, of_any_type, 3), (std::vector<double>{0, 0, 0, 0, 1}));
}

}  // namespace
}  // namespace arenite::peridynamics
