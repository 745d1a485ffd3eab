#include "grains/fields/laboratory/test_in_space.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "grains/fields/laboratory/test_kind.hpp"
#include "grains/fields/laboratory/test_numbers.hpp"
#include "support/pressed_spheres.hpp"
#include "support/sheared_spheres.hpp"

namespace arenite::fields {
namespace {

using test::pressed_spheres;

TEST(TestInSpace, WithoutPressureOnTheSidesItIsUniaxialCompression) {
  const Numbers numbers = test_numbers(pressed_spheres(5, 0));
  EXPECT_FALSE(numbers.contains("peak"));
  EXPECT_NEAR(numbers["uniaxial"]["strength_Pa"].get<double>(), 5 / 1e-4, 1e-6 * 5e4);
  EXPECT_NEAR(numbers["uniaxial"]["strain_at_strength"].get<double>(), 0.005, 1e-12);
}

TEST(TestInSpace, BetweenSidesThatPressThePeakIsOfTheRatio) {
  const Numbers numbers = test_numbers(pressed_spheres(5, 1));
  EXPECT_FALSE(numbers.contains("uniaxial"));
  // At the largest axial stress of 50 kPa the others are 10 kPa on sides that are half a per cent lower.
  EXPECT_NEAR(numbers["peak"]["q_over_p"].get<double>(), 3 * 40.0 / 70, 0.02);
  EXPECT_NEAR(numbers["peak"]["strain"].get<double>(), 0.005, 2e-4);
}

TEST(TestInSpace, TheCriticalStateHasTheRatioThatIsBorne) {
  SphereResult result = test::cube_of_spheres(2);
  test::shear_the_cell(result, 0.01);
  const Numbers numbers = test_numbers(result);
  ASSERT_TRUE(numbers.contains("critical_state"));
  EXPECT_NEAR(numbers["critical_state"]["mu"]["value"].get<double>(), 0.4, 1e-3);
}

TEST(TestInSpace, AStageThatClosesNothingHasNone) {
  SphereResult result = pressed_spheres(5, 1);
  result.asked.closes = -1;
  EXPECT_TRUE(test_numbers(result).empty());
}

TEST(TestInSpace, HasTheNumbersOfATestOfDisks) {
  SphereResult sheared = test::cube_of_spheres(2);
  test::shear_the_cell(sheared, 0.01);
  const Numbers numbers = test_numbers(sheared);
  for (const char* path : {"/critical_state/sure", "/critical_state/mu/low_95", "/critical_state/solid_fraction/value",
                           "/end/strain", "/end/volumetric_strain"})
    EXPECT_TRUE(numbers.at_path(path)) << path;
  const Numbers uniaxial = test_numbers(pressed_spheres(5, 0));
  for (const char* path : {"/uniaxial/modulus_Pa", "/uniaxial/failed"}) EXPECT_TRUE(uniaxial.at_path(path)) << path;
}

TEST(TestInSpace, OfAnExtensionIsAsLargeAsOfACompression) {
  SphereResult drawn = pressed_spheres(1, 5);  // the axial stress is below the others
  for (auto& column : drawn.history.columns)
    if (column.name == "top_position")
      for (double& v : column.values) v = 0.02 - v;
  const auto curves = test_curves(drawn);
  ASSERT_TRUE(curves);
  EXPECT_GT(curves->strain.back(), 0.009);
  EXPECT_GT(curves->ratio[20], 0.5);
  EXPECT_EQ(kind_of(drawn), TestKind::biaxial);
}

TEST(TestInSpace, ASampleThatIsHardlyStrainedIsNotTested) {
  SphereResult hardly = test::cube_of_spheres(2);
  test::shear_the_cell(hardly, 1e-6);
  EXPECT_FALSE(test_curves(hardly));
  EXPECT_TRUE(test_numbers(test::cube_of_spheres(0)).empty());
}

}  // namespace
}  // namespace arenite::fields
