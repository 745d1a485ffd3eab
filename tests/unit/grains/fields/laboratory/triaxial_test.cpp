#include "grains/fields/laboratory/triaxial.hpp"

#include <gtest/gtest.h>

#include "support/pressed_spheres.hpp"

namespace arenite::fields {
namespace {

TEST(Triaxial, StrainsReferToTheBoxBeforeNotToTheFirstRow) {
  SphereResult result = test::pressed_spheres(5, 1);
  result.asked.box = {0.01, 0.0102, 0.01};  // 2 % went by before the first row
  const auto curves = triaxial_curves(result, 1);
  ASSERT_TRUE(curves);
  EXPECT_NEAR((*curves)["axial_strain"].front(), 1 - 1 / 1.02, 1e-12);
  EXPECT_NEAR((*curves)["axial_strain"].back(), 1 - 0.99 / 1.02, 1e-12);
  EXPECT_NEAR((*curves)["volumetric_strain"].back(), 1 - 0.99 / 1.02, 1e-12);
}

}  // namespace
}  // namespace arenite::fields
