#include "grains/fields/steady_state.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "core/random.hpp"

namespace arenite::fields {
namespace {

/// x_k = mean + phi (x_(k-1) - mean) + noise, of unit variance, in its steady state from the start; plus a transient
/// `jump` exp(-k/`decay`).
std::vector<double> ar1(std::uint64_t seed, std::size_t n, double phi, double mean, double jump = 0, double decay = 1) {
  RandomStream random(seed, Purpose::test, static_cast<std::uint64_t>(static_cast<std::int64_t>(1000 * phi)));
  std::vector<double> x(n);
  double state = random.normal();
  for (std::size_t k = 0; k < n; ++k) {
    x[k] = mean + state + jump * std::exp(-static_cast<double>(k) / decay);
    state = phi * state + std::sqrt(1 - phi * phi) * random.normal();
  }
  return x;
}

/// Of many series: share that is found steady, and of these the share whose interval holds the truth, and means of
/// error and of samples an independent one.
struct Rate {
  double reached = 0, covered = 0, error = 0, independent = 0;
};
Rate over_series(int series, std::size_t n, double phi, double jump, double decay) {
  Rate rate;
  for (int k = 0; k < series; ++k) {
    const SteadyState s = find_steady_state(ar1(static_cast<std::uint64_t>(k), n, phi, 5, jump, decay));
    if (!s.reached) continue;
    const statistics::Interval i = statistics::confidence_95(s.mean);
    ++rate.reached;
    rate.covered += i.low <= 5 && 5 <= i.high;
    rate.error += s.mean.error;
    rate.independent += s.samples_per_independent;
  }
  for (double Rate::*sum : {&Rate::covered, &Rate::error, &Rate::independent}) rate.*sum /= rate.reached;
  rate.reached /= series;
  return rate;
}

TEST(SteadyState, IntervalOfCorrelatedSamplesCoversTheTruthAtItsRate) {
  // Blocks of 2 B samples underrate the variance of the mean by phi/((1 - phi^2) B), B = (2 n g^2)^(1/3), g = (1 +
  // phi)/(1 - phi): by 4 % at most here, and as much again because B is chosen from the data; together that takes 1 %
  // off the coverage, the cut where the series pleases another. The rate of 500 series scatters by 1 %: 95 % less three
  // of these and what is underrated is 90 %.
  for (const double phi : {0.0, 0.5, 0.8, 0.9}) {
    const double g = (1 + phi) / (1 - phi);
    const Rate still = over_series(500, 2500, phi, 0, 1), jumping = over_series(500, 2500, phi, 20, 30);
    for (const Rate& r : {still, jumping}) {
      EXPECT_GT(r.covered, 0.90) << phi;
      EXPECT_LT(r.covered, 0.98) << phi;
      EXPECT_GT(r.reached, 0.98) << phi;
    }
    EXPECT_NEAR(still.error / std::sqrt(g / 2500), 0.95, 0.08)
        << phi;  // half of the variance's 10 %, and what is cut adds a little
    EXPECT_NEAR(still.independent / g, 0.93, 0.12) << phi;
    // With a transient a few hundred samples less are left.
    EXPECT_GT(jumping.error, still.error);
    EXPECT_LT(jumping.error, 1.25 * still.error);
  }
}

TEST(SteadyState, ErrorOfDeparturesThatUndoEachOtherIsThatOfWhatRemains) {
  // Integral control: a departure is made good by the next steps. The mean of n samples scatters by sqrt((1 + phi)/(1 -
  // phi)/n), which for -0.9 is 0.23 of what as many independent ones would.
  for (const double phi : {-0.5, -0.9}) {
    const double g = (1 + phi) / (1 - phi);
    const Rate r = over_series(500, 2500, phi, 0, 1);
    EXPECT_NEAR(r.error / std::sqrt(g / 2500), 1.0, 0.15) << phi;
    EXPECT_GT(r.covered, 0.90) << phi;
    EXPECT_LT(r.covered, 0.98) << phi;
  }
  // Where nothing remains, sums of all departures being bounded, the error falls with every longer block; that of six
  // is sqrt(6) times too large.
  double squares = 0, told = 0;
  constexpr int series = 200, n = 480;
  for (int k = 0; k < series; ++k) {
    RandomStream random(static_cast<std::uint64_t>(k), Purpose::test, 7);
    std::vector<double> x;
    double before = random.normal();
    for (int i = 0; i < n; ++i) {
      const double now = random.normal();
      x.push_back(now - before);
      before = now;
    }
    const SteadyState s = block_average(x);
    EXPECT_LE(s.mean.freedom, 5);
    squares += s.mean.value * s.mean.value;
    told += s.mean.error * s.mean.error;
  }
  EXPECT_NEAR(std::sqrt(told / squares), std::sqrt(6.0), 0.3);
}

/// Of the mean of many series: its scatter, the error that departures tell (both root mean squares), and that of
/// blocks.
struct OfDepartures {
  double scatter = 0, told = 0, blocks = 0;
};

template <class Series> OfDepartures of_departures(Series&& series) {
  constexpr int count = 200;
  OfDepartures of;
  for (std::uint64_t seed = 0; seed < count; ++seed) {
    const std::vector<double> x = series(seed);
    const auto square = [](double v) { return v * v / count; };
    of.scatter += square(statistics::mean_of(x).value);
    of.told += square(error_of_departures(x));
    of.blocks += square(block_average(x).mean.error);
  }
  return {std::sqrt(of.scatter), std::sqrt(of.told), std::sqrt(of.blocks)};
}

TEST(SteadyState, ErrorOfAServosLoadKnowsWhatIsMadeGoodLate) {
  // A side whose place fluctuates about one, for 30 samples, and whose servo moves it by what the load departs: the
  // load is the rate of its place and some noise of its own.
  const auto held = [](std::uint64_t seed) {
    std::vector<double> place = ar1(seed, 1701, 1 - 1 / 30.0, 0), smooth(place.size(), place.front());
    for (std::size_t k = 1; k < place.size(); ++k) smooth[k] = smooth[k - 1] + (place[k] - smooth[k - 1]) / 10;
    std::vector<double> x;
    for (std::size_t k = 1; k < smooth.size(); ++k) x.push_back(smooth[k] - smooth[k - 1]);
    return x;
  };
  const OfDepartures servo = of_departures(held);
  EXPECT_GT(servo.told, 0.9 * servo.scatter);
  EXPECT_LT(servo.told, 1.5 * servo.scatter) << "more than it is, since no power below 0 is believed";
  EXPECT_GT(servo.blocks, 2 * servo.scatter);
  // Where nothing is made good, errors are those of independent departures.
  for (const double phi : {0.0, 0.9}) {
    const OfDepartures free = of_departures([&](std::uint64_t seed) { return ar1(seed, 1700, phi, 0); });
    EXPECT_NEAR(free.told / free.scatter, 1.0, 0.25) << phi;
  }
  EXPECT_TRUE(std::isnan(error_of_departures(std::vector<double>(47, 1.0))));
  EXPECT_LT(error_of_departures(std::vector<double>(48, 1.0)), 1e-12);
}

TEST(SteadyState, BeginsWhereTheTransientHasDecayed) {
  // A jump of 20 deviations, exp(-k/50): at 20 exp(-3.0) = 1 deviation it is lost in the noise, which takes 150
  // samples; twice the point found lies between that and half the series.
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    const SteadyState s = find_steady_state(ar1(seed, 3000, 0.5, -2, 20, 50));
    EXPECT_TRUE(s.reached);
    EXPECT_GT(s.first, 150u);
    EXPECT_LT(s.first, 900u);
    EXPECT_EQ(s.first + s.count, 3000u);
    EXPECT_NEAR(s.deviation, 1, 0.15);  // 2500 samples, three to an independent one: 2.4 %, six of them
  }
}

TEST(SteadyState, IsNotReachedByASeriesThatDrifts) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    std::vector<double> x = ar1(seed, 2000, 0.5, 0);
    for (std::size_t k = 0; k < x.size(); ++k) x[k] += 0.01 * static_cast<double>(k);  // by 20 deviations
    const SteadyState s = find_steady_state(x);
    EXPECT_FALSE(s.reached);
    EXPECT_EQ(s.first, 1000u);
  }
}

TEST(SteadyState, FollowsTheUnitOfItsSamples) {
  const std::vector<double> x = ar1(3, 1500, 0.7, 0, 10, 40);
  std::vector<double> y;
  for (const double v : x) y.push_back(1e6 - 1e-3 * v);
  const SteadyState a = find_steady_state(x), b = find_steady_state(y);
  EXPECT_EQ(a.first, b.first);
  EXPECT_EQ(a.block, b.block);
  EXPECT_NEAR(b.mean.value, 1e6 - 1e-3 * a.mean.value, 1e-9);  // rounding of 1e6
  EXPECT_NEAR(b.mean.error, 1e-3 * a.mean.error,
              1e-6 * b.mean.error);  // samples are rounded by 1e-10, 1e-7 of their deviation
}

TEST(SteadyState, OfAConstantHasNoError) {
  const SteadyState s = find_steady_state(std::vector<double>(100, 3.5));
  EXPECT_TRUE(s.reached);
  EXPECT_EQ(s.first, 0u);
  EXPECT_EQ(s.mean.value, 3.5);
  EXPECT_EQ(s.mean.error, 0);
  EXPECT_EQ(s.deviation, 0);
}

TEST(SteadyState, OfFewSamplesHasAMeanWithoutError) {
  const SteadyState s = find_steady_state(std::vector<double>{1, 2, 3, 4});
  EXPECT_FALSE(s.reached);
  EXPECT_DOUBLE_EQ(s.mean.value, 2.5);
  EXPECT_TRUE(std::isnan(s.mean.error));
  EXPECT_TRUE(std::isnan(find_steady_state(std::vector<double>{}).mean.value));
  // Forty samples of which none is independent of another: a slow half wave.
  std::vector<double> slow;
  for (int k = 0; k < 40; ++k) slow.push_back(std::cos(k * 3.14 / 40));
  EXPECT_TRUE(std::isnan(block_average(slow).mean.error));
}

TEST(SteadyState, RefusesWhatIsNoSeries) {
  EXPECT_THROW(find_steady_state(std::vector<double>{1, NAN, 2}), InputError);
}

}  // namespace
}  // namespace arenite::fields
