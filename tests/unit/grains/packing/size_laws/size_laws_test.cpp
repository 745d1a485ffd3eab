#include "grains/packing/size_laws/size_laws.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace arenite::packing {
namespace {

constexpr int count = 20'000;

template <class Law> std::vector<double> sorted_draws(const Law& law) {
  RandomStream random(7, Purpose::test);
  std::vector<double> d(count);
  for (int k = 0; k < count; ++k) d[static_cast<std::size_t>(k)] = law.draw(k, random);
  std::sort(d.begin(), d.end());
  return d;
}

/// Kolmogorov and Smirnov's distance; beyond 1.95/sqrt(n) in one of a thousand samples of the distribution itself.
template <class Law, class Distribution> void expect_drawn_from(const Law& law, Distribution&& below) {
  const auto d = sorted_draws(law);
  double distance = 0;
  for (std::size_t k = 0; k < d.size(); ++k)
    distance = std::max(distance, std::abs(below(d[k]) - (static_cast<double>(k) + 0.5) / count));
  EXPECT_LT(distance, 1.95 / std::sqrt(count));
  EXPECT_LE(d.back(), law.largest());
}

TEST(SizeLaws, PowerLawIsDrawnFromItsDistribution) {
  for (const double exponent : {-1.0, 1.0, 2.5}) {
    PowerLawSizes law;
    law.min = 1, law.max = 8, law.exponent = exponent;
    const double p = 1 - exponent;
    expect_drawn_from(law, [&](double d) {
      return std::abs(p) < 1e-9 ? std::log(d) / std::log(8) : (std::pow(d, p) - 1) / (std::pow(8, p) - 1);
    });
  }
}

TEST(SizeLaws, LogNormalIsDrawnFromItsDistribution) {
  LogNormalSizes law;
  law.min = 1, law.max = 4, law.median = 2, law.spread = 0.5;
  const auto phi = [](double d) { return 0.5 * std::erfc(-std::log(d / 2) / (0.5 * std::sqrt(2.0))); };
  expect_drawn_from(law, [&](double d) { return (phi(d) - phi(1)) / (phi(4) - phi(1)); });
}

TEST(SizeLaws, WeibullIsDrawnFromItsDistribution) {
  WeibullSizes law;
  law.min = 0.5, law.max = 3, law.scale = 1.5, law.shape = 2.2;
  const auto above = [](double d) { return std::exp(-std::pow(d / 1.5, 2.2)); };
  expect_drawn_from(law, [&](double d) { return (above(0.5) - above(d)) / (above(0.5) - above(3)); });
}

TEST(SizeLaws, SieveCurveComesBackByMass) {
  const SieveCurve law{{1, 2, 4, 5}, {0, 0.2, 0.9, 1}};
  const auto d = sorted_draws(law);
  double all = 0;
  for (const double v : d) all += v * v;
  for (const auto& [size, passing] : {std::pair{1.5, 0.1}, {2.0, 0.2}, {3.0, 0.55}, {4.0, 0.9}, {4.5, 0.95}}) {
    double below = 0;
    for (const double v : d) below += v <= size ? v * v : 0.0;
    EXPECT_NEAR(below / all, passing, 0.02);  // some 5000 grains weigh: 1/sqrt(5000)
  }
  EXPECT_GE(d.front(), 1);
  EXPECT_LE(d.back(), 5);
}

}  // namespace
}  // namespace arenite::packing
