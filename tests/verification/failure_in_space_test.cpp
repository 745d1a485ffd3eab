#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "solid/peridynamics/cracks.hpp"
#include "solid/peridynamics/critical_stretch.hpp"
#include "solid/peridynamics/damage.hpp"
#include "solid/peridynamics/failure_bonds.hpp"
#include "solid/peridynamics/failure_state.hpp"
#include "solid/peridynamics/measures.hpp"
#include "support/element_samples.hpp"

namespace arenite::peridynamics {
namespace {

using Options = DamageOptionsIn<3>;
using Result = DamageResultIn<3>;

/// Toughness that breaks bonds at strains where the linearised stretch holds.
Options brittle(Loading loading = Loading::tension, int horizon = 2) {
  Options options;
  options.toughness = {1e-5, 1e-5, 3.5e-5};
  options.loading = loading;
  options.horizon_in_space = horizon;
  return options;
}

/// A layer at this height, from the left to `end`, cut through.
std::vector<Cut> cut_at(double height, double end) { return {{{-1, height}, {end, height}}}; }

TEST(FailureInSpace, BondsAcrossAPlaneTakeTheEnergyThatToughnessAsksFor) {
  const double dx = 1e-3, young = 3e9;
  for (const int horizon : {2, 3}) {
    Options options = brittle(Loading::tension, horizon);
    options.stiffness = {young, young, young};
    options.toughness = {2e6, 2e6, 2e6};
    const double stretch = critical_stretches(options, dx)[matrix_bond];
    constexpr int n = 11;
    const VoxelMap map = test::solid(n, n, n, dx);
    const SpaceBonds bonds = make_space_bonds(map, options.stiffness, horizon);
    double energy = 0;  // of the bonds of the column in the middle of the cube that cross its middle, one by one
    for (int level = 0; level < n; ++level)
      each_bond_of_level(bonds, bonds.words, level, [&](const SpaceBond& b) {
        if (b.x == n / 2 && b.y == n / 2 && b.z <= n / 2 && b.z + b.along.z > n / 2)
          energy += energy_modulus(bonds, b, dx) * stretch * stretch / 2;
      });
    const double toughness = 2e6 * 2e6 * (1 - 1 / 16.0) / young;
    EXPECT_NEAR(energy / (dx * dx) / toughness, 1, 1e-6) << horizon;
    const double across = std::pow(2e6 / young / stretch, 2) * (1 - 1 / 16.0) / dx;  // by the table of docs/voxels.md
    EXPECT_NEAR(across, horizon == 2 ? 2.17732 : 3.39972, 1e-5);
    const auto limits = breaking_limits(options, dx);
    EXPECT_TRUE(limits.follow_spacing());
    EXPECT_NEAR(breaking_limits(options, dx / 4).stretch[matrix_bond] / limits.stretch[matrix_bond], 2, 1e-12);
  }
}

/// A bar cut through at mid-height, or not, until its first bond breaks.
Result cut_bar(Loading loading, std::vector<Cut> cuts, bool stays_open = false) {
  Options options = brittle(loading);
  options.max_events = 1;
  options.cracks_stay_open = stays_open;
  options.tolerance = 1e-10;
  options.cuts = std::move(cuts);
  return load_to_failure<3>(test::solid(10, 8, 16), options);
}

TEST(FailureInSpace, ACutBarIsAsStiffAsAWholeOneInCompressionAndCarriesNothingInTension) {
  const std::vector<Cut> through = cut_at(7.5, 11), half = cut_at(7.5, 5);
  const double whole = cut_bar(Loading::compression, {}).modulus;
  EXPECT_NEAR(cut_bar(Loading::compression, through).modulus / whole, 1, 1e-3);
  EXPECT_EQ(cut_bar(Loading::tension, through).ending, Result::Ending::no_path);
  EXPECT_EQ(cut_bar(Loading::compression, through, true).ending, Result::Ending::no_path);
  EXPECT_NEAR(cut_bar(Loading::compression, half).modulus / whole, 1, 1e-3);
  EXPECT_LT(cut_bar(Loading::tension, half).modulus / whole, 0.9);
}

TEST(FailureInSpace, ANotchedBarBreaksAlongItsNotchAndBalancesItsEnergy) {
  for (const int horizon : {2, 3}) {
    constexpr int width = 12, depth = 30;
    Options options = brittle(Loading::tension, horizon);
    options.cuts = cut_at(depth / 2 - 0.5, 0.6 * width);
    options.end_stress = 1e-3;
    const VoxelMap map = test::solid(width, 8, depth);
    const Result result = load_to_failure<3>(map, options);
    EXPECT_TRUE(result.ending == Result::Ending::severed || result.ending == Result::Ending::dropped)
        << result.sentence;
    EXPECT_LT(result.energy_defect, 1e-4);
    EXPECT_GE(result.curve.back().released, result.curve.back().bond_energy * (1 - 1e-6));
    const auto cracks = space_cracks_of(result.broken, horizon, map.dx);
    const auto astray = std::ranges::count_if(
        cracks, [&](const SpaceCrack& c) { return std::abs(static_cast<double>(c.z) - depth / 2.0) > horizon + 1; });
    EXPECT_LT(astray, std::ssize(cracks) / 20) << horizon;
    const auto damage = damage_of(map, result.broken, horizon);
    const auto at = [&](int z) { return damage[map.index(width - 3, 4, z)]; };
    EXPECT_GT(std::max(at(depth / 2 - 1), at(depth / 2)), 0.3f) << "ahead of the notch";
    EXPECT_LT(at(3), 0.05f);
    EXPECT_LE(std::ranges::max(damage), 1.0f);
  }
}

/// A wide plate cracked halfway from the left, clamped along both long edges: a crack that runs frees what the bar
/// stores far ahead of its tip, half of an uncut plate's modulus times strain^2, times the height.
double running_strain_over_griffith(int height) {
  const VoxelMap map = test::solid(4 * height, 5, height);
  Options options = brittle();
  options.end_stress = 0.95;
  Options uncut = options;
  uncut.max_events = 1;
  const double modulus = load_to_failure<3>(map, uncut).modulus;
  options.cuts = cut_at(height / 2 - 0.5, 2.0 * height);
  const Result result = load_to_failure<3>(map, options);
  double strain = 0;
  for (const DamageState& state : result.curve) strain = std::max(strain, state.strain);
  const double toughness = std::pow(options.toughness.matrix, 2) * (1 - 1 / 16.0);  // for E = 1
  return strain / std::sqrt(2 * toughness / (modulus * (height - 1) * map.dx));
}

TEST(FailureInSpace, ACrackRunsALittleAboveGriffithsStrain) {
  const double ratio = running_strain_over_griffith(16);
  EXPECT_GT(ratio, 1);
  EXPECT_LT(ratio, 1.35);
}

TEST(FailureInSpace, ASampleThatIsTurnedAboutTheLoadBreaksAtTheSameStress) {
  VoxelMap map = test::random_voxels(9, 9, 10);
  VoxelMap turned = map;  // x and y exchanged
  for (int z = 0; z < 10; ++z)
    for (int y = 0; y < 9; ++y)
      for (int x = 0; x < 9; ++x) {
        turned.phase[turned.index(y, x, z)] = map.phase[map.index(x, y, z)];
        turned.grain[turned.index(y, x, z)] = map.grain[map.index(x, y, z)];
      }
  Options options = brittle();
  options.tolerance = 1e-10;
  options.max_events = 12;
  const Result one = load_to_failure<3>(map, options), other = load_to_failure<3>(turned, options);
  ASSERT_GT(one.strength, 0);
  EXPECT_NEAR(other.strength / one.strength, 1, 1e-6);
  EXPECT_EQ(other.broken.size(), one.broken.size());
}

TEST(FailureInSpace, ResumedATestHasTheBitsOfOneInOnePiece) {
  const VoxelMap map = test::random_voxels(10, 8, 12);
  for (const int horizon : {2, 3}) {
    Options options = brittle(Loading::compression, horizon);
    options.max_events = 15;
    options.max_strain = 1e-2;
    std::vector<FailureStateIn<3>> states;
    options.keep = [&](const auto& state) { states.push_back(state()); };
    const Result whole = load_to_failure<3>(map, options);
    ASSERT_GT(states.size(), 8u);
    options.keep = {};
    const auto bytes = to_bytes(states[7]);
    const auto state = failure_state_of<3>(bytes);
    options.resume = &state;
    const Result resumed = load_to_failure<3>(map, options);
    ASSERT_EQ(resumed.curve.size(), whole.curve.size());
    for (std::size_t k = 0; k < whole.curve.size(); ++k) ASSERT_EQ(resumed.curve[k].stress, whole.curve[k].stress);
    EXPECT_EQ(resumed.broken.size(), whole.broken.size());
    EXPECT_EQ(resumed.at_strength.zz, whole.at_strength.zz);
    EXPECT_THROW(failure_state_of<2>(bytes), InputError);
    EXPECT_THROW(load_to_failure<3>(test::random_voxels(9, 8, 12), options), InputError);
  }
}

}  // namespace
}  // namespace arenite::peridynamics
