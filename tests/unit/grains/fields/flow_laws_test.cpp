#include "grains/fields/flow_laws.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace arenite::fields {
namespace {

TEST(FlowLaws, BeverloosLawIsFoundAgain) {
  const std::vector<double> opening{0.03, 0.04, 0.055, 0.075, 0.1};
  std::vector<double> rate, error;
  for (const double d : opening) rate.push_back(33 * std::pow(d - 0.0096, 1.5)), error.push_back(0.01 * rate.back());
  const BeverlooLaw law = fit_beverloo(opening, rate, error);
  EXPECT_NEAR(law.exponent.value, 1.5, 1e-4);
  EXPECT_NEAR(law.lost_width.value, 0.0096, 1e-5);
  EXPECT_GT(law.exponent.error, 0.02);
  const BeverlooLaw given = fit_beverloo(opening, rate, error, 1.5);
  EXPECT_NEAR(given.factor.value, 33, 33e-6);
  EXPECT_TRUE(std::isnan(given.exponent.error));
  EXPECT_THROW(fit_beverloo({0.1}, {1}, {0.1}), InputError);
  EXPECT_THROW(fit_beverloo({0.1, 0.1}, {1, 2}, {0.1, 0.1}), InputError);
  EXPECT_THROW(fit_beverloo({0, 0.1}, {1, 2}, {0.1, 0.1}), InputError);
}

TEST(FlowLaws, BothRegimesOfRunOutAreFoundAgain) {
  const std::vector<double> aspect{0.5, 0.8, 1.3, 2, 3, 4.5, 7, 11, 17};
  std::vector<double> way;
  for (const double a : aspect) way.push_back(a < 2.5 ? 2 * a : 2 * std::cbrt(2.5) * std::pow(a, 2.0 / 3));
  const RunoutLaws laws = fit_runout(aspect, way);
  EXPECT_NEAR(laws.low->exponent.value, 1, 1e-4);
  EXPECT_NEAR(laws.high->exponent.value, 2.0 / 3, 1e-4);
  EXPECT_FALSE(fit_runout({1, 2, 9}, {1, 2, 3}).low);
  EXPECT_FALSE(fit_runout({1, 1, 1}, {1, 2, 3}).low);
  EXPECT_THROW(fit_runout({1, std::nan(""), 2}, {1, 2, 3}), InputError);
}

TEST(FlowLaws, JanssensLawIsFoundAgain) {
  const std::vector<double> height{0.05, 0.1, 0.2, 0.3, 0.5, 0.8};
  std::vector<double> pressure, liquid;
  for (const double h : height) pressure.push_back(-900 * std::expm1(-h / 0.12)), liquid.push_back(7500 * h);
  const JanssenLaw law = fit_janssen(height, pressure, std::vector<double>(6, 5.0), liquid);
  EXPECT_NEAR(law.saturation.value, 900, 0.09);
  EXPECT_NEAR(law.length.value, 0.12, 1.2e-5);
  const std::vector<double> width(6, 0.08), friction(6, 0.4), ratio(6, 0.8);
  EXPECT_NEAR(length_by_stresses(width, friction, ratio).value, 0.08 / 0.64, 1e-12);
}

TEST(FlowLaws, RootsOfBeverloosRatesLieOnALine) {
  for (const int dimension : {2, 3}) {
    const double n = beverloo_exponent(dimension), relative = 1e-3;
    std::vector<double> rate, error;
    for (const double opening : {0.03, 0.04, 0.05}) {
      rate.push_back(7 * std::pow(opening - 0.01, n));
      error.push_back(relative * rate.back());
    }
    const auto roots = roots_of_rates(rate, error, n);
    EXPECT_NEAR(roots[1].value - roots[0].value, roots[2].value - roots[1].value, 1e-12);
    EXPECT_NEAR(roots[1].error / roots[1].value, relative / n, 1e-12);
    const BeverlooLaw law{{7}, {0.01}, {n}};
    EXPECT_NEAR(law.root_at(0.05), roots[2].value, 1e-12);
  }
}

}  // namespace
}  // namespace arenite::fields
