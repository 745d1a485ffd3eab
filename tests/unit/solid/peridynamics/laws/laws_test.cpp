#include "solid/peridynamics/laws/laws.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace arenite::peridynamics {
namespace {

/// What every bond law keeps to, whatever it is.
template <class Law> class EveryBondLaw : public ::testing::Test {};

template <class> struct TypesOf;
template <class... L> struct TypesOf<std::variant<L...>> { using type = ::testing::Types<L...>; };
TYPED_TEST_SUITE(EveryBondLaw, TypesOf<BondLawChoice>::type);

TYPED_TEST(EveryBondLaw, ForceIsTheGradientOfItsEnergy) {
  const TypeParam law;
  // The energy is a square: a central difference is exact but for rounding, 1e-16 * E(0.02)/(2e-4 F) of the force.
  for (const double extension : {-0.02, -0.005, 0.003, 0.02}) {
    const double step = 1e-4,
                 slope = (law.energy(extension + step, 3.0) - law.energy(extension - step, 3.0)) / (2 * step);
    EXPECT_NEAR(slope, law.force(extension, 3.0), 1e-12 * std::abs(slope)) << extension;
  }
  EXPECT_EQ(law.energy(0.0, 3.0), 0);
}

TYPED_TEST(EveryBondLaw, ForceIsProportionalToTheExtension) {
  const TypeParam law;
  EXPECT_EQ(law.force(8 * 0.003, 3.0), 8 * law.force(0.003, 3.0));
  EXPECT_EQ(law.force(-0.003, 3.0), -law.force(0.003, 3.0));
}

TYPED_TEST(EveryBondLaw, BreaksAtItsCriticalStretchAndInStretchOnly) {
  const TypeParam law;
  const double critical = law.critical_stretch(1e6, 3e9, 1e-3);
  EXPECT_GT(critical, 0);
  EXPECT_EQ(law.damage(critical, critical), 1);
  EXPECT_LT(law.damage(0.99 * critical, critical), 1);
  EXPECT_LE(law.damage(-2 * critical, critical), 0);
}

TYPED_TEST(EveryBondLaw, BrokenItPushesAndNeverPullsAndItsForceIsTheGradientOfItsEnergy) {
  const TypeParam law;
  const auto energy = [&](double e) { return law.resists_broken(e) ? law.energy(e, 3.0) : 0; };
  for (const double extension : {-0.02, -0.005, 0.0, 0.003, 0.02}) {
    const double step = 1e-4, slope = (energy(extension + step) - energy(extension - step)) / (2 * step);
    const double force = law.resists_broken(extension) ? law.force(extension, 3.0) : 0;
    EXPECT_LE(force, 0);
    // At 0 the two halves of the difference meet: off by their curvature times half a step.
    EXPECT_NEAR(slope, force, extension == 0 ? 3.0 * step / 4 * 1.01 : 1e-12) << extension;
  }
  EXPECT_LT(law.force(-0.02, 3.0), 0);
  EXPECT_TRUE(law.resists_broken(-1e-9));
  EXPECT_FALSE(law.resists_broken(1e-9));
}

TYPED_TEST(EveryBondLaw, HasAWordAndASentenceForRecipes) {
  EXPECT_FALSE(TypeParam::word.word.empty() || TypeParam::word.sentence.empty());
}

}  // namespace
}  // namespace arenite::peridynamics
