#include "statistics/fit_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"
#include "core/random.hpp"
#include "statistics/measured.hpp"

namespace arenite::statistics {
namespace {

const std::vector<double> places{1, 2, 3, 5, 8, 13};

TEST(FitLaw, FindsWhatPointsWereMadeWith) {
  const Law law = [](double x, const std::vector<double>& p) { return p[0] * (1 - std::exp(-x / p[1])); };
  std::vector<double> y;
  for (const double x : places) y.push_back(law(x, {900, 4}));
  const auto found = fit_law(law, {500, 1}, places, y, std::vector<double>(6, 5.0));
  EXPECT_NEAR(found[0].value, 900, 1e-4);
  EXPECT_NEAR(found[1].value, 4, 1e-6);
  EXPECT_GT(found[0].error, 1);
}

TEST(FitLaw, ErrorsAreThoseOfManySamples) {
  RandomStream random(3, Purpose::test);
  std::vector<double> exponents, told, errors;
  for (int k = 0; k < 400; ++k) {
    std::vector<double> y, error;
    for (const double x : places) {
      error.push_back(0.1 * std::pow(x, 0.7));
      y.push_back(2 * std::pow(x, 0.7) + error.back() * random.normal());
    }
    const PowerLaw law = fit_power(places, y, error);
    exponents.push_back(law.exponent.value);
    told.push_back(law.exponent.error);
  }
  const auto mean = mean_of(exponents);
  const double scatter = mean.error * std::sqrt(400.0);
  EXPECT_NEAR(mean.value, 0.7, 4 * mean.error);
  // An error is scaled up by scatter above it alone, by sqrt(chi^2/4) with four degrees of freedom: by a sixth on
  // average.
  EXPECT_GT(mean_of(told).value, scatter * 0.95);
  EXPECT_LT(mean_of(told).value, scatter * 1.35);
}

TEST(FitLaw, WithoutErrorsTheScatterTells) {
  const std::vector<double> none(6, unknown);
  std::vector<double> y;
  for (std::size_t k = 0; k < 6; ++k) y.push_back(3 * places[k] * (k % 2 == 0 ? 1.01 : 0.99));
  const PowerLaw law = fit_power(places, y, none);
  EXPECT_NEAR(law.exponent.value, 1, 0.03);
  EXPECT_GT(law.exponent.error, 1e-4);
  EXPECT_LT(law.exponent.error, 0.05);
}

TEST(FitLaw, RefusesWhatDeterminesNothing) {
  EXPECT_THROW(fit_power({1}, {1}, {1}), InputError);
  EXPECT_THROW(fit_power({1, 2, 3}, {1, 2}, {1, 1, 1}), InputError);
  EXPECT_THROW(fit_power({1, 2, -3}, {1, 2, 3}, {1, 1, 1}), InputError);
  EXPECT_THROW(fit_power({1, 2, 3}, {1, 2, 3}, {1, -1, 1}), InputError);
  EXPECT_THROW(fit_power({2, 2, 2}, {1, 2, 3}, {1, 1, 1}), InputError);
  EXPECT_THROW(fit_power({1, 2, unknown}, {1, 2, 3}, {1, 1, 1}), InputError);
}

}  // namespace
}  // namespace arenite::statistics
