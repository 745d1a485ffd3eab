#include "thermal/identify/constants.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

#include "core/random.hpp"

namespace arenite::identify {
namespace {

using statistics::Measured;

const Finding* named(const std::vector<Finding>& findings, const std::string& name) {
  for (const Finding& finding : findings)
    if (finding.name == name) return &finding;
  return nullptr;
}

TEST(Constants, AnAdhesionThatPullsOffAtItsForceHasTheSurfaceEnergyOfItsLaw) {
  // F(h) = k h - gamma sqrt(r h) is least, -F_c, where its slope is 0.
  const double k = 27.35e6, r = 12.4e-3, gamma = 1.5e5;
  const double h = std::pow(gamma * std::sqrt(r) / (2 * k), 2), force = gamma * std::sqrt(r * h) - k * h;
  const auto found = adhesion_findings({force, 0.02 * force, 4}, Pair{{k}, r});
  EXPECT_NEAR(named(found, "surface_energy")->value.value, gamma, 1e-9 * gamma);
  EXPECT_NEAR(named(found, "surface_energy")->value.error, 0.01 * gamma, 1e-9 * gamma);  // half of it, by the root
  EXPECT_NEAR(named(found, "threshold_force")->value.value, force, 1e-9 * force);
  const double free = named(found, "overlap_without_force")->value.value;
  EXPECT_NEAR(k * free, gamma * std::sqrt(r * free), 1e-9 * k * free);
  EXPECT_NEAR(named(found, "stiffness_over_surface_energy")->value.value, k / gamma, 1e-9 * k / gamma);
  EXPECT_EQ(adhesion_findings({force}, {}).size(), 1u);
}

TEST(Constants, AStiffnessOfAUnitOfLengthIsThatOverTheLength) {
  const auto found = stiffness_findings({27.35e6, 0.5e6, 3}, 0.06);
  EXPECT_NEAR(named(found, "stiffness_per_length")->value.value, 27.35e6 / 0.06, 1);
  EXPECT_NEAR(named(found, "stiffness_per_length")->value.error, 0.5e6 / 0.06, 1);
  EXPECT_EQ(stiffness_findings({1e6}, {}).size(), 1u);
}

/// A bar of modulus E under uniaxial stress: strain (1 - nu) s/E, cooling A s, and a signal of s/A'.
struct Bar {
  double young = 2.8e9, poisson = 0.35, factor = 1.5e-8, constant = 2e5;
  CausesAndResponses tests;
  Bar() {
    for (const double s : {1e6, 3e6, 4e6, 7e6}) {
      tests.stress.push_back(s);
      tests.strain.push_back(s * (1 - poisson) / young);
      tests.temperature.push_back(factor * s);
      tests.signal.push_back(s / constant);
    }
  }
};

TEST(Constants, StressAndStrainOfOneBarGiveOneFactorAndOneConstantOfItsSignal) {
  const Bar bar;
  const Elastic specimen{{bar.young, 0}, {bar.poisson, 0}};
  const auto all = factors_of(bar.tests, specimen, false);
  ASSERT_EQ(all.size(), 4u);
  const std::vector<std::string> names{"factor", "factor_from_strain", "signal_constant",
                                       "signal_constant_from_strain"};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_EQ(all[k].constant.name, names[k]);
    const double right = all[k].of_temperature ? bar.factor : bar.constant;
    EXPECT_NEAR(all[k].factor.factor.value, right, 1e-9 * right);
    EXPECT_FALSE(misses_origin(all[k].factor));
  }
  Bar strained;
  strained.tests.stress.clear(), strained.tests.signal.clear();
  const auto one = factors_of(strained.tests, specimen, true);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].constant.name, "factor");  // the only one needs no other name
  EXPECT_FALSE(intercept_of(one[0]));
}

TEST(Constants, ALineThatMissesTheOriginIsSeen) {
  Bar bar;
  for (std::size_t k = 0; k < 4; ++k) bar.tests.temperature[k] += 0.05 + (k % 2 == 0 ? 1e-4 : -1e-4);
  bar.tests.signal.clear(), bar.tests.strain.clear();
  const auto found = factors_of(bar.tests, {}, false);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(misses_origin(found[0].factor));
  EXPECT_NEAR(intercept_of(found[0])->value.value, 0.05, 1e-3);
  EXPECT_EQ(intercept_of(found[0])->unit, "K");
}

TEST(Constants, AmplitudesAreHalfOfPeakToPeakValues) {
  EXPECT_EQ(peak_to_peak({1, -2}, AmplitudeConvention::amplitude), (std::vector<double>{2, -4}));
  EXPECT_EQ(peak_to_peak({1, -2}, AmplitudeConvention::peak_to_peak), (std::vector<double>{1, -2}));
}

TEST(Constants, ASignalAtTheDetectorsOwnTemperatureNeedsNoCorrection) {
  const Detector detector{{0.02}, {2, 0}, {0.9, 0}, 300, 300, {3.6e-6, 5.1e-6}};
  const auto found = direct_findings(detector, {1.5e-8});
  const double right = 0.02 * 2 / (0.9 * 1.5e-8);  // D F/(eps A), R = 1
  EXPECT_NEAR(named(found, "signal_constant_direct")->value.value, right, 1e-9 * right);
  EXPECT_NEAR(named(found, "signal_constant_direct_in_band")->value.value, right, 1e-6 * right);
}

}  // namespace
}  // namespace arenite::identify
