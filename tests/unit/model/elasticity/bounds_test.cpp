#include "model/elasticity/bounds.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

namespace arenite::elasticity {
namespace {

TEST(ModulusBounds, OfOnePhaseAreItsModulus) {
  const ModulusBounds b = modulus_bounds({{1, 3e9}}).value();
  for (const double e : {b.voigt, b.reuss, b.shtrikman_upper, b.shtrikman_lower}) EXPECT_NEAR(e, 3e9, 1);
}

TEST(ModulusBounds, OfAFewHolesFallByThreeTimesTheirShare) {
  // A plate with round holes of small share c has E (1 - 3 c), which is the upper bound.
  const double c = 1e-6;
  const ModulusBounds b = modulus_bounds({{1 - c, 1}, {c, 0}}).value();
  EXPECT_NEAR((1 - b.shtrikman_upper) / c, 3, 1e-4);
  EXPECT_EQ(b.reuss, 0);
  EXPECT_EQ(b.shtrikman_lower, 0);
}

TEST(ModulusBounds, OfEqualSharesAreTheClosedForms) {
  const ModulusBounds b = modulus_bounds({{0.5, 4}, {0.5, 1}}).value();
  EXPECT_DOUBLE_EQ(b.voigt, 2.5);
  EXPECT_DOUBLE_EQ(b.reuss, 1.6);
}

TEST(ModulusBounds, OfHolesDoNotDependOnPoissonsRatio) {
  // Cherkaev, Lurie and Milton (1992): the modulus of a plate with holes is the same whatever Poisson's ratio.
  for (const double poisson : {0.0, 0.2, 0.45})
    EXPECT_NEAR(modulus_bounds({{0.8, 1, poisson}, {0.2, 0, 0.1}}).value().shtrikman_upper, 0.8 / (1 + 2 * 0.2), 1e-12);
}

TEST(ModulusBounds, AreNotToldWherePhasesDifferInPoissonsRatio) {
  EXPECT_FALSE(modulus_bounds({{0.5, 4, 0.2}, {0.5, 1, 0.3}}));
  EXPECT_TRUE(modulus_bounds({{0.5, 4, 0.2}, {0.4, 1, 0.2}, {0.1, 0, 0.3}}));
}

RC_GTEST_PROP(ModulusBounds, NestInTheirOrder, ()) {
  const double a = *rc::gen::inRange(1, 1000), c = *rc::gen::inRange(1, 1000), d = *rc::gen::inRange(0, 1000),
               sum = a + c + d;
  const double young = *rc::gen::inRange(1, 100);
  const ModulusBounds b =
      modulus_bounds({{a / sum, young}, {c / sum, 1}, {d / sum, *rc::gen::inRange(0, 2) * 0.5}}).value();
  RC_ASSERT(b.reuss <= b.shtrikman_lower * (1 + 1e-12));
  RC_ASSERT(b.shtrikman_lower <= b.shtrikman_upper * (1 + 1e-12));
  RC_ASSERT(b.shtrikman_upper <= b.voigt * (1 + 1e-12));
}

TEST(Bounds, OfAFewSphericalPoresAreTheDiluteOnes) {
  // Mackenzie (1950): K falls by c (1 + 3 K/(4 G)), G by 5 c (3 K + 4 G)/(9 K + 8 G).
  const double c = 1e-6, k = 3, g = 2;
  const auto upper = bounds<3>({{1 - c, {k, g}}, {c, {}}}).shtrikman_upper;
  EXPECT_NEAR((1 - upper.bulk / k) / c, 1 + 3 * k / (4 * g), 1e-4);
  EXPECT_NEAR((1 - upper.shear / g) / c, 5 * (3 * k + 4 * g) / (9 * k + 8 * g), 1e-4);
}

TEST(Bounds, OfAFewRoundHolesAreTheDiluteOnes) {
  const double c = 1e-6, k = 3, g = 2;
  const auto upper = bounds<2>({{1 - c, {k, g}}, {c, {}}}).shtrikman_upper;
  EXPECT_NEAR((1 - upper.bulk / k) / c, 1 + k / g, 1e-4);
  EXPECT_NEAR((1 - upper.shear / g) / c, 2 * (1 + g / k), 1e-4);
}

}  // namespace
}  // namespace arenite::elasticity
