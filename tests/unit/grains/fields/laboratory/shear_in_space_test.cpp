#include "grains/fields/laboratory/shear_in_space.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "grains/fields/laboratory/curves_in_space.hpp"
#include "support/sheared_spheres.hpp"

namespace arenite::fields {
namespace {

TEST(ShearInSpace, ACellThatIsShearedHasItsStrainSinceTheFirstRowAndItsStresses) {
  SphereResult result = test::cube_of_spheres(2);
  test::shear_the_cell(result, 0.01);
  const auto curves = curves_in_space(result, -1);
  ASSERT_TRUE(curves);
  EXPECT_EQ((*curves)["time"].back(), 400);
  EXPECT_EQ((*curves)["shear_strain"].front(), 0);
  EXPECT_NEAR((*curves)["shear_strain"].back(), 4, 1e-12);
  EXPECT_NEAR((*curves)["tau"].front(), 20e3, 1e-6);
  EXPECT_NEAR((*curves)["normal_stress"].front(), 50e3, 1e-6);
  EXPECT_NEAR((*curves)["mu"].front(), 0.4, 1e-12);
  EXPECT_NEAR((*curves)["inertial_number"][200], 0.01 * 2e-3 / std::sqrt(50e3 / 2500), 1e-9);
}

TEST(ShearInSpace, SidesThatSlideShearWhatIsBetweenThem) {
  SphereResult result = test::cube_of_spheres(-2);
  std::vector<double> slid = *result.history.find("time");
  for (double& v : slid) v *= -1e-4;
  result.history.columns.push_back({"top_slid", "m", slid});
  const auto curves = curves_in_space(result, -1);
  ASSERT_TRUE(curves);
  EXPECT_NEAR(std::abs((*curves)["shear_strain"].back()), 4, 1e-9);
  EXPECT_NEAR(std::abs((*curves)["mu"].front()), 0.4, 1e-12);
}

TEST(ShearInSpace, ABoxThatNothingShearsHasNone) { EXPECT_FALSE(curves_in_space(test::cube_of_spheres(0), -1)); }

}  // namespace
}  // namespace arenite::fields
