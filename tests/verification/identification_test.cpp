#include <gtest/gtest.h>

#include <cmath>

#include "workflow/identify/identify_curves.hpp"
#include "workflow/identify/identify_factor.hpp"

/// The thesis's tables of its identification tests (T chapter 2).
namespace {
using namespace arenite;
using identify::Finding;

std::string table(const std::string& name) {
  return std::string(ARENITE_SOURCE_DIR) + "/examples/data/thesis-identification/" + name;
}

const Finding& finding(const identify::Group& group, const std::string& name) {
  for (const auto& f : group.findings)
    if (f.name == name) return f;
  throw std::out_of_range(name);
}

double to_digits(double value, int digits) {
  const double unit = std::pow(10.0, std::floor(std::log10(value)) - digits + 1);
  return std::round(value / unit) * unit;
}

TEST(Identification, SurfaceEnergiesOfTable23ToThreeDigits) {
  workflow::AdhesionRequest request;
  request.stiffness = statistics::Measured{27.35e6};
  request.radii = {6.2e-3, 6.2e-3};
  request.stated = table("stated-surface-energy.csv");
  for (const auto kind : {identify::EffectiveRadius::four_reduced, identify::EffectiveRadius::sum,
                          identify::EffectiveRadius::geometric_mean}) {
    request.effective_radius = kind;
    const auto found = workflow::identify_adhesion(table("separation-force.csv"), request);
    ASSERT_EQ(found.groups.size(), 4U);
    const double printed[] = {0.268, 0.511, 0.745, 1.060};
    for (std::size_t g = 0; g < 4; ++g) {
      const auto& gamma = finding(found.groups[g], "surface_energy");
      EXPECT_NEAR(to_digits(gamma.value.value / 1e6, 3), printed[g], 1e-12) << found.groups[g].name;
      EXPECT_TRUE(agrees(finding(found.groups[g], "separation_force")));
      EXPECT_EQ(agrees(gamma), g < 3) << "1.0608 rounds to 1.061, 1.060 is printed";
      const double force = finding(found.groups[g], "separation_force").value.value;
      EXPECT_NEAR(finding(found.groups[g], "threshold_force").value.value, force, 1e-12 * force);
    }
  }
}

TEST(Identification, MeansOfTable21AndWhereThePrintedOnesSlip) {
  workflow::StiffnessRequest request;
  request.stated = table("stated-stiffness-pom.csv");
  const auto found = workflow::identify_stiffness(table("contact-stiffness-pom.csv"), request);
  ASSERT_EQ(found.groups.size(), 3U);
  ASSERT_TRUE(found.all);
  const auto mean = [&](std::size_t g) { return finding(found.groups[g], "stiffness"); };
  EXPECT_NEAR(mean(0).value.value, 29.27e6, 0.005e6);
  EXPECT_NEAR(mean(1).value.value, 25.63e6, 0.005e6);
  EXPECT_NEAR(mean(2).value.value, 27.335e6, 1);
  EXPECT_TRUE(agrees(mean(0)));
  EXPECT_FALSE(agrees(mean(1))) << "25.45 is printed";
  EXPECT_TRUE(agrees(mean(2)));
  const auto all = finding(*found.all, "stiffness");
  EXPECT_NEAR(all.value.value, 27.41e6, 0.005e6);
  EXPECT_FALSE(agrees(all)) << "27.35 is printed";
  EXPECT_NEAR((29.27 + 25.45 + 27.33) / 3, 27.35, 0.005) << "which follows from the slip above";
  const auto range = statistics::confidence_95(all.value);
  EXPECT_TRUE(range.low < 27.35e6 && 27.35e6 < range.high) << "and does no harm";
}

TEST(Identification, MeanOfTable22) {
  workflow::StiffnessRequest request;
  request.stated = table("stated-stiffness-hdpe.csv");
  const auto found = workflow::identify_stiffness(table("contact-stiffness-hdpe.csv"), request);
  ASSERT_EQ(found.groups.size(), 1U);
  const auto k = finding(found.groups[0], "stiffness");
  EXPECT_NEAR(k.value.value, 38.50e6 / 6, 1e-3);
  EXPECT_FALSE(agrees(k)) << "6.43 is printed";
  EXPECT_EQ(found.groups[0].tests.size(), 6U);
}

TEST(Identification, FactorsFromPropertiesSayThatTheThesissArePeakToPeak) {
  const auto found = workflow::identify_factor(table("properties.csv"), {});
  ASSERT_EQ(found.groups.size(), 2U);
  const double measured[] = {0.0150e-6, 0.0258e-6};  // T 2.3
  for (std::size_t g = 0; g < 2; ++g) {
    const double from_properties = finding(found.groups[g], "factor").value.value;
    EXPECT_NEAR(from_properties / measured[g], 1, 0.06);  // amplitudes would be off by 2
  }
}

}  // namespace
