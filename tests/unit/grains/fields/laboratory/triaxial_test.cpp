#include "grains/fields/laboratory/triaxial.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace arenite::fields {
namespace {

/// A cube of 10 mm that y closes by 1 % over 40 rows, to a force of `top` that is largest half way, between sides with
/// `side`.
SphereResult pressed_spheres(double top, double side) {
  constexpr std::size_t rows = 41;
  SphereResult result;
  result.asked.closes = 1;
  result.snapshots.emplace_back();
  const auto add = [&](const std::string& name, auto value) {
    std::vector<double> values;
    for (std::size_t k = 0; k < rows; ++k) values.push_back(value(static_cast<double>(k) / (rows - 1)));
    result.history.columns.push_back({name, "", values});
  };
  for (const auto& [low, high] : {std::pair{"left", "right"}, {"bottom", "top"}, {"back", "front"}}) {
    const bool closes = std::string(low) == "bottom";
    add(std::string(low) + "_position", [](double) { return 0.0; });
    add(std::string(high) + "_position", [&](double t) { return closes ? 0.01 * (1 - 0.01 * t) : 0.01; });
    for (const char* of : {low, high})
      add(std::string(of) + "_force", [&](double t) { return closes ? top * 4 * t * (1 - t) : side; });
  }
  return result;
}

TEST(Triaxial, WithoutPressureOnTheSidesItIsUniaxialCompression) {
  const Numbers numbers = triaxial_numbers(pressed_spheres(5, 0));
  EXPECT_FALSE(numbers.contains("peak"));
  EXPECT_NEAR(numbers["uniaxial"]["strength_Pa"].get<double>(), 5 / 1e-4, 1e-6 * 5e4);
  EXPECT_NEAR(numbers["uniaxial"]["strain_at_strength"].get<double>(), 0.005, 1e-12);
}

TEST(Triaxial, BetweenSidesThatPressThePeakIsOfTheRatio) {
  const Numbers numbers = triaxial_numbers(pressed_spheres(5, 1));
  EXPECT_FALSE(numbers.contains("uniaxial"));
  // At the largest axial stress of 50 kPa the others are 10 kPa on sides that are half a per cent lower.
  EXPECT_NEAR(numbers["peak"]["q_over_p"].get<double>(), 3 * 40.0 / 70, 0.02);
  EXPECT_NEAR(numbers["peak"]["axial_strain"].get<double>(), 0.005, 2e-4);
}

TEST(Triaxial, StrainsReferToTheBoxBeforeNotToTheFirstRow) {
  SphereResult result = pressed_spheres(5, 1);
  result.asked.box = {0.01, 0.0102, 0.01};  // 2 % went by before the first row
  const auto curves = triaxial_curves(result, 1);
  ASSERT_TRUE(curves);
  EXPECT_NEAR((*curves)["axial_strain"].front(), 1 - 1 / 1.02, 1e-12);
  EXPECT_NEAR((*curves)["axial_strain"].back(), 1 - 0.99 / 1.02, 1e-12);
  EXPECT_NEAR((*curves)["volumetric_strain"].back(), 1 - 0.99 / 1.02, 1e-12);
}

TEST(Triaxial, AStageThatClosesNothingHasNone) {
  SphereResult result = pressed_spheres(5, 1);
  result.asked.closes = -1;
  EXPECT_TRUE(triaxial_numbers(result).empty());
}

}  // namespace
}  // namespace arenite::fields
