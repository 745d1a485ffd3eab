#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "thermal/inference/presence.hpp"

namespace arenite::inference {
namespace {

/// A thousand contacts with exponential forces and overlaps linear in them, and some hundreds of gaps; `noise` in mean
/// forces, reported `reported` times as large.
struct Drawn {
  ContactEvidence evidence;
  std::vector<std::uint8_t> there;
  double mean = 0, absent_force = 0;

  Drawn(double noise, double reported, std::uint64_t seed, std::size_t offered = 300) {
    RandomStream random(seed, Purpose::test, 2);
    constexpr double force = 1000, gap = 0.6e-3, rim = 0.06e-3;
    evidence.widest_gap = gap;
    for (std::size_t c = 0; c < 1000 + offered; ++c) {
      const bool is = c < 1000;
      const double f = is ? -force * std::log(1 - random.uniform()) : 0;
      const double overlap =
          is ? 0.1e-3 * f / force + rim * random.normal() : -gap * random.uniform() + rim * random.normal();
      if (overlap < -gap) continue;
      there.push_back(is);
      mean += f / 1000;
      evidence.fn.push_back(f + noise * force * random.normal());
      evidence.fn_error.push_back(reported * noise * force);
      evidence.overlap.push_back(overlap);
      evidence.kind.push_back(static_cast<int>(c % 2));
    }
  }
};

TEST(Presence, CountsContactsThatAreThereWhateverTheNoise) {
  for (const double noise : {0.005, 0.02, 0.05, 0.1})
    for (const double reported : {1.0, 0.6}) {
      const Drawn d(noise, reported, 4);
      const Presence found = presence(d.evidence);
      EXPECT_NEAR(found.expected, 1000, 20) << noise << ' ' << reported;
      const auto taken = taken_as_present(found);
      double count = 0, sum = 0, wrong = 0;
      for (std::size_t c = 0; c < taken.size(); ++c)
        count += taken[c], sum += taken[c] * d.evidence.fn[c], wrong += taken[c] != d.there[c];
      EXPECT_NEAR(sum / count, d.mean, 0.02 * d.mean) << noise << ' ' << reported;
      EXPECT_LT(wrong, 1300 * (0.01 + noise)) << noise << ' ' << reported;
      if (noise > 0.01) { EXPECT_NEAR(found.error_scale, 1 / reported, 0.25 / reported) << noise << ' ' << reported; }
    }
}

TEST(Presence, ThreeErrorsWouldLoseWeakContacts) {
  const Drawn d(0.05, 1, 9);
  double count = 0, sum = 0;
  for (std::size_t c = 0; c < d.evidence.fn.size(); ++c)
    if (d.evidence.fn[c] > 3 * d.evidence.fn_error[c]) sum += d.evidence.fn[c], ++count;
  EXPECT_GT(sum / count, 1.1 * d.mean);  // the rule that this one takes the place of
}

TEST(Presence, AContactThatLostItsForceIsGoneAndNotIdle) {
  Drawn d(0.02, 1, 5);
  for (int k = 0; k < 60; ++k) {  // opened on the way: apart at the end, with a loss
    d.evidence.fn.push_back(-200 - 5 * k);
    d.evidence.fn_error.push_back(20);
    d.evidence.overlap.push_back(-0.3e-3);
    d.evidence.kind.push_back(0);
  }
  const Presence found = presence(d.evidence);
  for (std::size_t c = d.there.size(); c < d.evidence.fn.size(); ++c) {
    EXPECT_LT(found.probability[c], 0.1);
    EXPECT_LT(found.idle[c], 0.1);
  }
}

TEST(Presence, NothingProposedIsNothingThere) {
  EXPECT_EQ(presence({}).expected, 0);
  EXPECT_TRUE(taken_as_present({}).empty());
}

}  // namespace
}  // namespace arenite::inference
